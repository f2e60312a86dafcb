#!/usr/bin/env bash
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
#
# A Slurm of one node on this machine, without systemd, all of it in one folder:
# munged, slurmctld and slurmd of Debian, which are installed if need be.
#
# usage: scripts/slurm_here.sh start FOLDER CORES    (as root)
#        scripts/slurm_here.sh kill FOLDER    kill -9 of the controller, and a new one
#        scripts/slurm_here.sh stop FOLDER
# Then SLURM_CONF=FOLDER/slurm.conf leads sbatch and the others to it.
set -euo pipefail

action=${1:?start, kill or stop}
folder=$(realpath -m "${2:?a folder}")
export SLURM_CONF=$folder/slurm.conf

stop() {
  local name
  for name in slurmd slurmctld munged; do
    [[ -s $folder/$name.pid ]] && kill "$(<"$folder/$name.pid")" 2>/dev/null || true
  done
}

if [[ $action == stop ]]; then
  scancel --full --state=PENDING,RUNNING --user=root 2>/dev/null || true
  stop
  exit
fi

if [[ $action == kill ]]; then
  kill -9 "$(<"$folder/slurmctld.pid")"
  sleep 1
  slurmctld -f "$SLURM_CONF"
  # A killed controller has forgotten the last seconds: a job that it launches twice
  # makes the node refuse (drained), and one that has ended meanwhile seems to run on
  # until it asks the node. An administrator does both by hand.
  for _ in $(seq 15); do
    sleep 1
    if sinfo -h -o %T | grep -q drain; then
      scontrol update NodeName="$(hostname -s)" State=RESUME
      echo "slurm: the node was drained, and is back"
    fi
  done
  scontrol reconfigure
  exit
fi

cores=${3:?cores}
if ((EUID != 0)); then
  echo "slurm: slurmd starts jobs as their users and has to be root" >&2
  exit 2
fi
if ! dpkg -s slurmctld slurmd slurm-client munge >/dev/null 2>&1; then
  # Nothing is to start by itself.
  DEBIAN_FRONTEND=noninteractive RUNLEVEL=1 apt-get -qq install -y \
    --no-install-recommends slurmctld slurmd slurm-client munge >/dev/null
fi
mkdir -p "$folder"/{munge,state,spool}
chmod 0700 "$folder/munge"
chmod 0755 "$folder"
head -c 64 /dev/urandom >"$folder/munge/key"
chmod 0400 "$folder/munge/key"
host=$(hostname -s)
cat >"$SLURM_CONF" <<EOF
ClusterName=here
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=36817
SlurmdPort=36818
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
ReturnToService=2
SchedulerParameters=batch_sched_delay=0,sched_min_interval=100000
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$cores RealMemory=$(free -m | awk '/^Mem/ { print int($2 * 0.9) }') State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
EOF
trap stop ERR
# munged wants no folder on the way to be open to others; /tmp is. It is enough
# here that the folder of the key is not.
munged --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" \
  --pid-file="$folder/munged.pid" --log-file="$folder/munge/log" \
  --seed-file="$folder/munge/seed" 2>"$folder/munged.err"
slurmctld -f "$SLURM_CONF"
slurmd -f "$SLURM_CONF"
for _ in $(seq 60); do
  [[ $(sinfo -h -o %T 2>/dev/null) == idle ]] && break
  sleep 0.5
done
if [[ $(sinfo -h -o %T) != idle ]]; then
  echo "slurm: the node does not come up:" >&2
  tail -n 20 "$folder"/slurm*.log >&2
  stop
  exit 1
fi
echo "slurm: $(slurmctld -V), a node of $cores core(s), is up in $folder"
