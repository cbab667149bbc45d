# SPDX-License-Identifier: BSD-3-Clause
"""HTML that notebooks are shown, as tests read it."""

from html.parser import HTMLParser


class Page(HTMLParser):
    """Tags that are open or do not fit, and what the cells and rows of tables hold."""

    def __init__(self, text):
        super().__init__()
        self.open, self.cells, self.rows = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.open.append(tag)
        if tag in ("td", "th"):
            self.cells.append("")
        if tag == "tr":
            self.rows.append([])

    def handle_startendtag(self, tag, attrs):
        pass

    def handle_endtag(self, tag):
        assert self.open.pop() == tag
        if tag in ("td", "th"):
            self.rows[-1].append(self.cells[-1])

    def handle_data(self, data):
        if self.open and self.open[-1] in ("td", "th"):
            self.cells[-1] += data
