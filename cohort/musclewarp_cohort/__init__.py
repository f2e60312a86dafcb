# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""What musclewarp-cohort and its Snakefile are made of (docs/cohort.md).

table     reads IN/subjects.tsv: a job for each subject and motion
flags     knows the flags of musclewarp-deform, and splits those of the table
job       runs musclewarp-deform for one of them, and says how it ended
group     gathers what the jobs wrote in group.tsv
curves    takes lengths, moment arms and volumes from a report
outliers  says which subjects are far from the others
page      shows all that as group.html; comparison, plots and markup are its parts
engine    calls Snakemake, whose words go to a log
progress  says on the screen how far the jobs are

Only the standard library of Python is needed.
"""

VERSION = "0.2.0"
