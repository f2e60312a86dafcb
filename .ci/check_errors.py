#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Fails when docs/errors.md does not explain the messages that the sources have.

usage: .ci/check_errors.py [--list]

Messages are the problems of InputError and of functions that make one of a
parameter, the errors of options, shortcomings, warnings and notes, why a solver
stopped, and what Python raises. The pattern of a message is its text with "…" where
values stand. Tables of docs/errors.md have patterns as code in the first cell of a
row. Every pattern of the sources has to be there, and every pattern that is there has
to be in the sources. --list prints the patterns of the sources with their places.
"""
import ast
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = "docs/errors.md"
CODE = ("src/", "problems/", "tools/", "python/src/", "python/musclewarp/",
        "cohort/musclewarp_cohort/")

LITERAL = r'"((?:\\.|[^"\\\n])*)"'
TOKEN = re.compile(r"//[^\n]*|" + LITERAL + r"|(?<!\w)'(?:\\.|[^'\\\n])+'")
FUNCTION = re.compile(
    r"\b([A-Z]\w*)\(([^(){};]*)\)\s*(?:const\s*)?(?:override\s*)?\{")
# Where an expression is a message, and which argument of a call it is.
CALLS = {"InputError": 1, "End": 1, "Finish": 1, "Interrupted": 0, "runtime_error": 0}
PLACES = re.compile(r"\b(?:shortcomings|warnings|notes)_?(?:->|\.)(?:push|emplace)_back\("
                    r"|\bshortcomings\.insert\([^,]*,"
                    r"|\bFrameFailure\{|return \{std::nullopt,|\bscreen_? <<(?= \"warning: )"
                    r"|\*error_? =|LOG\(WARNING\) <<|\bmessage =\s")

PYTHON_CALLS = re.compile(r"(?:InputError|ImportError|TypeError|^problems\.append|^_problem"
                          r"|^where(?:\(.*\))?)$")


def without_comments(text):
    """The text with blanks for comments, so that places stay."""
    return TOKEN.sub(lambda token: re.sub(".", " ", token[0])
                     if token[0].startswith("//") else token[0], text)


def parts(text, separators, start=0):
    """The parts of a text between separators that are in no brackets and strings,
    up to the bracket that closes what is around it, and where that is."""
    found, depth, begin, at = [], 0, start, start
    while at < len(text):
        token = TOKEN.match(text, at)
        if token:
            at = token.end()
            continue
        character = text[at]
        if character in "([{":
            depth += 1
        elif character in ")]}":
            if depth == 0:
                break
            depth -= 1
        elif depth == 0 and character in separators:
            found.append(text[begin:at])
            begin = at + 1
        at += 1
    return found + [text[begin:at]], at


def pattern(words):
    """The pattern of a text that is put together from these expressions."""
    text = ""
    for word in words:
        word = re.sub(r"^(?:std::string)?\((.*)\)$", r"\1", word.strip(), flags=re.S)
        is_text = re.fullmatch(rf"(?:\s*{LITERAL})+\s*", word)
        text += "".join(re.findall(LITERAL, word)) if is_text else "…"
    text = text.replace('\\"', '"').replace("\\n", " ").replace("\\\\", "\\")
    text = re.sub(r"\{(\w+)\}", r"--\1", text)  # base/setting_names.h
    return " ".join(re.sub("…+", "…", text).split())


def has_words(text):
    return re.search(r"[^\W\d_]", text)


class Sources:
    """The sources without comments, and the functions in them."""

    def __init__(self, texts):
        self.texts = {path: without_comments(text) for path, text in texts.items()}
        self.functions = {}  # the bodies by name
        self.makers = {}  # by file without extension: functions and their argument
        for path, text in self.texts.items():
            for match in FUNCTION.finditer(text):
                body = text[match.end():parts(text, "", match.end())[1]]
                self.functions.setdefault(match[1], []).append(body)
                index = self.parameter_that_is_a_problem(match[2], body)
                if index is not None:
                    self.makers.setdefault(path.rsplit(".", 1)[0], {})[match[1]] = index
        self.included = {path: [
            folder + name for name in re.findall(r'#include "(.*)"', text)
            for folder in ("src/", "", "python/src/") if folder + name in texts]
            for path, text in texts.items()}

    @staticmethod
    def parameter_that_is_a_problem(parameters, body):
        names = [re.findall(r"\w+", name.split("=")[0])[-1:]
                 for name in parameters.split(",")]
        for call in re.finditer(r"\bInputError\(", body):
            arguments, _ = parts(body, ",", call.end())
            if len(arguments) > 1 and [arguments[1].strip()] in names:
                return names.index([arguments[1].strip()])
        return None

    @staticmethod
    def patterns_of_stream(name, before):
        """The patterns of what is written to a stream, one for each side of an else."""
        texts, end = [[]], 0
        for written in re.finditer(rf"\b{name}\s*<<", before):
            statement = parts(before, ";", written.end())[0][0]
            words = [word for word in parts(statement, "<")[0] if word.strip()]
            if re.search(r"\belse\b[^}]*$", before[end:written.start()]):
                texts += [text[:-1] + [words] for text in texts]
            else:
                texts = [text + [words] for text in texts]
            end = written.end()
        return [pattern(word for words in text for word in words) for text in texts]

    def patterns(self, expression, before, depth=0):
        """The patterns of an expression, which follows the text before it."""
        expression = expression.strip()
        if depth > 4:
            return ["…"]
        choice, _ = parts(expression, "?")
        if len(choice) == 2:
            sides, _ = parts(choice[1].replace("::", "  "), ":")
            return [one for side in sides
                    for one in self.patterns(side, before, depth + 1)]
        bracket = expression.find("(") + 1
        is_call = bracket and parts(expression, "", bracket)[1] == len(expression) - 1
        if is_call and bracket == 1:
            return self.patterns(expression[1:-1], before, depth + 1)
        moved = re.fullmatch(r"std::move\((\w+)\)|\*(\w+)", expression)
        if moved:
            expression = moved[1] or moved[2]
        stream = re.fullmatch(r"(\w+)\.str\(\)", expression)
        if stream:
            return self.patterns_of_stream(stream[1], before)
        if re.fullmatch(r"\w+", expression):
            said = list(re.finditer(rf"\b{expression}(?:\[\])?\s*=(?!=)", before))
            return [one for value in said for one in self.patterns(
                parts(before, ";", value.end())[0][0], before[:value.start()],
                depth + 1)] or ["…"]
        call = re.match(r"(?:\w+(?:\.|->|::))?([A-Z]\w*)\(", expression)
        if is_call and call and call[1] != "Sentence":
            return [one for body in self.functions.get(call[1], [])
                    for value in re.finditer(r"\breturn\s", body)
                    for one in self.patterns(parts(body, ";", value.end())[0][0],
                                             body[:value.start()], depth + 1)]
        words, _ = parts(expression, "+")
        if len(words) > 1 and not has_words(pattern(words)):
            return [one for word in words
                    for one in self.patterns(word, before, depth + 1)]
        return [pattern(words)]

    def makers_for(self, path):
        """The calls that make messages in a file, with the place of the argument."""
        calls, seen = dict(CALLS), [path]
        for name in seen:  # which grows
            calls.update(self.makers.get(name.rsplit(".", 1)[0], {}))
            seen += [other for other in self.included[name] if other not in seen]
        return calls

    def messages(self, path):
        """Yields the place and the expression of each message of a source."""
        text = self.texts[path]
        for name, index in self.makers_for(path).items():
            for call in re.finditer(rf"\b{name}\(", text):
                arguments, _ = parts(text, ",", call.end())
                if index < len(arguments):
                    yield call.start(), arguments[index]
        for call in re.finditer(r"\bSentence\(", text):
            yield call.start(), "+".join(
                f"({word})" for word in parts(text, ",", call.end())[0])
        for place in PLACES.finditer(text):
            words, _ = parts(text, ";", place.end())
            yield place.start(), re.sub(r"\s<<\s", " + ", words[0])
        if path.endswith("/solver_summary.cc"):  # the names of StopReason
            for value in re.finditer(r'case .*:\s*return ("\w+");', text):
                yield value.start(), value[1]

    def all_patterns(self):
        """Yields the place and the pattern of each message."""
        for path, text in self.texts.items():
            for at, expression in self.messages(path):
                begin = text.rfind("\n}", 0, at) + 1
                line = text.count("\n", 0, at) + 1
                for one in self.patterns(expression, text[begin:at]):
                    yield f"{path}:{line}", re.sub("^warning: ", "", one)


def python_patterns(path, text):
    """Yields the place and the pattern of each message of a Python file."""
    def pattern_of(node):
        if isinstance(node, ast.BinOp):
            return pattern_of(node.left) + pattern_of(node.right)
        values = node.values if isinstance(node, ast.JoinedStr) else [node]
        return "".join(value.value if isinstance(value, ast.Constant) else "…"
                       for value in values)

    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Call):
            name = ast.unparse(node.func)
            arguments = [] if not PYTHON_CALLS.search(name) else (
                node.args[4:5] if name == "_problem" else node.args[1:2] or (
                    [] if name == "where" else node.args[:1]))
            for argument in arguments:
                text = re.sub("…+", "…", " ".join(pattern_of(argument).split()))
                yield f"{path}:{node.lineno}", text


def patterns_of_sources():
    """The places of each pattern that has words."""
    said = subprocess.run(
        ["git", "-c", "safe.directory=*", "ls-files", "*.h", "*.cc", "*.py"],
        cwd=ROOT, check=True, text=True, stdout=subprocess.PIPE).stdout
    texts = {path: (ROOT / path).read_text(encoding="utf-8") for path in said.split()
             if path.startswith(CODE) and (ROOT / path).exists()}
    told = list(Sources({path: text for path, text in texts.items()
                         if not path.endswith(".py")}).all_patterns())
    for path, text in texts.items():
        if path.endswith(".py"):
            told += python_patterns(path, text)
    found = {}
    for place, one in told:
        if has_words(one):
            found.setdefault(one, []).append(place)
    return found


def patterns_of_page():
    """The line of each pattern of the page."""
    found = {}
    lines = (ROOT / PAGE).read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, 1):
        cells = re.split(r"(?<!\\)\|", line)
        if line.startswith("|") and len(cells) > 3:
            for one in re.findall(r"`([^`]+)`", cells[1]):
                found.setdefault(one.replace("\\|", "|"), number)
    return found


def main(arguments):
    if arguments not in ([], ["--list"]):
        sys.exit(__doc__)
    sources = patterns_of_sources()
    if arguments:
        for one, places in sorted(sources.items(), key=lambda item: item[1]):
            print(f"{places[0]}: {one}" + "".join(f"\n    {p}" for p in places[1:]))
        return 0
    page = patterns_of_page()
    told = [f"{places[0]}: `{one}` is not in {PAGE}: add it to a row of a table there"
            for one, places in sources.items() if one not in page]
    told += [f"{PAGE}:{line}: no source says `{one}`: correct or remove it"
             for one, line in page.items() if one not in sources]
    for line in told:
        print(f"messages: {line}", file=sys.stderr)
    if told:
        return 1
    print(f"messages: {len(sources)}, all in {PAGE}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
