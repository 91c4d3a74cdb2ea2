#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A chart of a report as a picture of its own.

    chart_of_report.py report.html SECTION TEXT... > chart.svg

The first chart with these texts in it, of the report's section with the id SECTION.
"""
import re
import sys

report, section, *texts = sys.argv[1:]
page = open(report, encoding="utf-8").read()
part = page.split(f'<section id="{section}">')[1].split("</section>")[0]
charts = [svg for svg in re.findall(r"<svg.*?</svg>", part, re.DOTALL) if all(text in svg for text in texts)]
if not charts:
    sys.exit(f"There is no chart with {texts} in section '{section}' of {report}.")
print('<?xml version="1.0" encoding="UTF-8"?>')
print(charts[0])
