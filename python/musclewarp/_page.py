# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of a run, for notebooks and files."""
import html
import os
from typing import Union

from musclewarp import _core


class Page:
    """A page that needs no server and no other file (docs/page.md).

    A notebook shows it in a frame.

    Attributes:
        html: the text of the page.
        height: of the frame in a notebook, pixels.
    """

    def __init__(self, text: str, height: int = 720) -> None:
        self.html = text
        self.height = height

    def write(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the page to a file, to be opened in a browser."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.html)

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.html)}" width="100%" '
                f'height="{self.height}" frameborder="0"></iframe>')


def page(folder: Union[str, "os.PathLike[str]"]) -> Page:
    """Returns the page of a run that Run.write() or musclewarp-deform wrote.

    What crosses is counted anew on the files.

    Raises:
        InputError: names the file that is missing or damaged.
    """
    return Page(_core.page_of_folder(os.fspath(folder)))
