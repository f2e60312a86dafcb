# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Pieces of HTML that all parts of the page share."""
import html


def escape(value):
    return html.escape(str(value))


def number(value, digits=3):
    """A number as text; "" for None."""
    return "" if value is None else f"{value:.{digits}g}"


def table(heads, rows):
    """`heads` are names, or (name, class); cells are HTML. Where the screen is
    narrow, the table scrolls by itself."""
    heads = [head if isinstance(head, tuple) else (head, "") for head in heads]
    lines = ['<div class="scroll"><table><thead><tr>']
    lines += [f'<th class="{kind}">{escape(name)}</th>' for name, kind in heads]
    lines.append("</tr></thead><tbody>")
    for row in rows:
        lines.append("<tr>" + "".join(
            f'<td class="{kind}">{cell}</td>'
            for cell, (_, kind) in zip(row, heads)) + "</tr>")
    return "\n".join(lines + ["</tbody></table></div>"])
