#!/bin/sh
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# Says how a job of Slurm stands: running, success or failed, as Snakemake 7 wants
# to know it. A job that is over leaves scontrol after some minutes; then sacct
# knows it, where there is accounting.
#
# usage: slurm_status.sh JOB
state=$(scontrol -o show job "$1" 2>/dev/null | sed -n 's/.* JobState=\([A-Z_]*\).*/\1/p')
[ -n "$state" ] ||
  state=$(sacct -n -X -P -j "$1" -o State 2>/dev/null | sed 's/ .*//')
case $state in
  COMPLETED) echo success ;;
  PENDING | CONFIGURING | RUNNING | COMPLETING | SUSPENDED | REQUEUED | REQUEUE_HOLD) echo running ;;
  STAGE_OUT | RESIZING | SIGNALING | STOPPED | SPECIAL_EXIT) echo running ;;
  *) # also where the controller does not answer: ask again before giving up
    if [ -z "$state" ] && ! scontrol ping >/dev/null 2>&1; then
      echo running
    else
      echo failed
    fi
    ;;
esac
