#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a command with a Slurm of one node of its own: with_slurm.sh FOLDER COMMAND…
# Its daemons live as long as the command, on this machine's loopback alone. Status 77: it does not come up here.
set -u
folder=$1
shift
host=$(hostname -s)
free_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'; }
mkdir -p "$folder/state" "$folder/spool"
export SLURM_CONF=$folder/slurm.conf
cat >"$SLURM_CONF" <<CONF
ClusterName=limn
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
NodeName=$host NodeAddr=127.0.0.1 CPUs=2
PartitionName=all Nodes=$host Default=YES State=UP
CONF
# Nothing asks it for a control group; looking for the kind of them fails where none is mounted, as in a container.
echo CgroupPlugin=cgroup/v1 >"$folder/cgroup.conf"
slurmctld -D -f "$SLURM_CONF" >"$folder/slurmctld.log" 2>&1 &
controller=$!
slurmd -D -f "$SLURM_CONF" >"$folder/slurmd.log" 2>&1 &
node=$!
trap 'kill $controller $node 2>/dev/null; wait $controller $node 2>/dev/null' EXIT
deadline=$((SECONDS + 60))
until [ "$(sinfo -h -o %T 2>/dev/null)" = idle ]; do
  if [ $SECONDS -gt $deadline ]; then
    cat "$folder/slurmctld.log" "$folder/slurmd.log" >&2
    exit 77
  fi
  sleep 0.2 # until the next look
done
"$@"
