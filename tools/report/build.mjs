import { copyFileSync } from "node:fs";
copyFileSync("index.html", process.argv[2]);
