#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# assets/jobs/export.sbatch on a real Slurm: its daemons and munge's run on this machine alone, with keys, sockets, ports
# and folders of their own, and are stopped at the end. A lesson drawn by an array of four has the bytes of one process.
set -euo pipefail
# shellcheck source=tests/jobs/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
PATH=$PATH:/usr/sbin
daemons=()

stop_all() {
  local i
  for ((i = ${#daemons[@]} - 1; i >= 0; --i)); do
    kill "${daemons[i]}" 2>/dev/null || true
    for _ in {1..50}; do kill -0 "${daemons[i]}" 2>/dev/null && sleep 0.1; done
    kill -9 "${daemons[i]}" 2>/dev/null || true
    wait "${daemons[i]}" 2>/dev/null || true
  done
  rm -rf -- "$scratch"
}
trap stop_all EXIT
trap 'exit 130' INT TERM
need munged slurmctld slurmd sbatch squeue sinfo scontrol
[ "$(id -u)" -eq 0 ] || skip "slurmd has to be root"

# start NAME COMMAND…: in the background, until stop_all.
start() {
  local name=$1
  shift
  "$@" >"$scratch/$name.out" 2>&1 &
  daemons+=($!)
}
# within SECONDS COMMAND…: waits until it succeeds.
within() {
  local tries=$(($1 * 10))
  shift
  for ((; tries > 0; --tries)); do
    "$@" && return
    sleep 0.1
  done
  return 1
}
cannot_start() { tail -n 5 -- "$scratch/$1".*; skip "$1 cannot start here"; }
free_port() {
  local port
  for _ in {1..100}; do
    port=$((20000 + RANDOM % 10000))
    (: <"/dev/tcp/127.0.0.1/$port") 2>/dev/null || { echo "$port" && return; }
  done
  return 1
}

mkdir "$scratch/state" "$scratch/spool"
(umask 077 && head -c 128 /dev/urandom >"$scratch/munge.key")
start munged munged --foreground --num-threads=2 --key-file="$scratch/munge.key" --socket="$scratch/munge.socket" \
  --pid-file="$scratch/munged.pid" --log-file="$scratch/munged.log" --seed-file="$scratch/munged.seed"
within 5 test -S "$scratch/munge.socket" || cannot_start munged

node=$(hostname -s)
controller_port=$(free_port)
node_port=$(free_port)
cat >"$scratch/slurm.conf" <<CONF
ClusterName=polhode-test
SlurmctldHost=$node(127.0.0.1)
SlurmUser=root
SlurmctldPort=$controller_port
SlurmdPort=$node_port
AuthType=auth/munge
AuthInfo=socket=$scratch/munge.socket
CredType=cred/munge
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd.pid
SlurmctldLogFile=$scratch/slurmctld.log
SlurmdLogFile=$scratch/slurmd.log
MailProg=/bin/true
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=1024
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE
CONF
export SLURM_CONF=$scratch/slurm.conf
start slurmctld slurmctld -D -i -f "$SLURM_CONF"
start slurmd slurmd -D -f "$SLURM_CONF" -N "$node"
is_idle() { [ "$(timeout 5 sinfo --noheader --format=%t 2>/dev/null)" = idle ]; }
within 10 is_idle || { tail -n 5 "$scratch/slurmctld".*; cannot_start slurmd; }

# run_array ARRAY DIR [OPTION…]: until all its tasks have ended; $job is its number.
run_array() {
  local array=$1
  shift
  job=$(cd "$scratch" && sbatch --parsable --array="$array" "$jobs/export.sbatch" "$lesson" "$@")
  has_ended() { [ -z "$(squeue --noheader --jobs="$job" 2>/dev/null)" ]; }
  within 30 has_ended || { squeue; fail "the array $array did not end"; }
}
# states: how the tasks of the last array ended, one word for each kind.
states() { scontrol --oneliner show job "$job" | sed -n 's/.* JobState=\([A-Z]*\) .*/\1/p' | sort -u; }
tell_logs() { cat "$scratch"/polhode-*.log; }

export_alone "$scratch/alone"
run_array 1-4 "$scratch/shared" "${options[@]}"
[ "$(states)" = COMPLETED ] || { tell_logs; fail "tasks of the array 1-4 ended as: $(states)"; }
expect_equal "$scratch/alone" "$scratch/shared"
expect_shares "$scratch"/polhode-"$job"_*.log

# Another array over what one that was cut short left: not from 1, in steps.
kept=$(export_shard 2/3 "$scratch/resumed")
run_array 3-7:2 "$scratch/resumed" "${options[@]}"
[ "$(states)" = COMPLETED ] || { tell_logs; fail "tasks of the array 3-7:2 ended as: $(states)"; }
expect_equal "$scratch/alone" "$scratch/resumed"
expect_kept "$kept" "$scratch/resumed"

run_array 1-2 "$scratch/failed" --size 1x0
[ "$(states)" = FAILED ] || fail "a task that could not draw ended as: $(states)"
