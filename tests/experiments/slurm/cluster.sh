#!/usr/bin/env bash
# A real Slurm of one machine in a folder of its own: munged, slurmctld and slurmd on loopback, with
# a key and ports that nothing else uses. As root:
#   cluster.sh start DIR | stop DIR | stop-controller DIR | start-controller DIR
# Clients need SLURM_CONF=DIR/slurm.conf. Needs Debian's slurm-wlm and munge.
set -euo pipefail
action=$1
mkdir -p "$2"
dir=$(cd "$2" && pwd)
export SLURM_CONF=$dir/slurm.conf

free_port()
{
    local port
    while :; do
        port=$((20000 + RANDOM % 12000))  # below those that the system hands out
        (exec 3<> "/dev/tcp/127.0.0.1/$port") 2>/dev/null || { echo "$port"; return; }
    done
}

write_configuration()
{
    local host
    host=$(hostname -s)
    cat > "$SLURM_CONF" <<CONF
ClusterName=vdamf-test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$dir/munge.socket
CredType=cred/munge
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd.pid
SlurmctldLogFile=$dir/slurmctld.log
SlurmdLogFile=$dir/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=10000
KillWait=2
SlurmdTimeout=30
SlurmctldTimeout=30
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$(awk '/MemTotal/ {print int($2 / 1100)}' /proc/meminfo) State=UNKNOWN
PartitionName=test Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
}

start_controller()
{
    slurmctld -f "$SLURM_CONF"
}

is_up()
{
    sinfo -h -o %t 2>/dev/null | grep -q -E '^(idle|mix|alloc)'
}

wait_until_up()
{
    local tries
    for tries in $(seq 150); do
        is_up && return 0
        sleep 0.2
    done
    echo "the cluster does not come up; see $dir/slurmctld.log and $dir/slurmd.log" >&2
    return 1
}

start()
{
    mkdir -p "$dir/state" "$dir/spool"
    [ -f "$dir/munge.key" ] || head -c 1024 /dev/urandom > "$dir/munge.key"
    chmod 600 "$dir/munge.key"
    munged --force --key-file="$dir/munge.key" --socket="$dir/munge.socket" \
        --pid-file="$dir/munged.pid" --log-file="$dir/munged.log" --seed-file="$dir/munged.seed"
    write_configuration
    start_controller
    slurmd -f "$SLURM_CONF"
    wait_until_up
}

# Ends a daemon and waits: a controller that is told to end saves its state first.
end_process()
{
    local pid tries
    pid=$(cat "$dir/$1.pid" 2>/dev/null) || return 0
    kill -TERM "$pid" 2>/dev/null || return 0
    for tries in $(seq 100); do
        kill -0 "$pid" 2>/dev/null || return 0
        sleep 0.1
    done
    kill -KILL "$pid" 2>/dev/null || true
}

case $action in
    start) start ;;
    stop) for daemon in slurmd slurmctld munged; do end_process "$daemon"; done ;;
    stop-controller) end_process slurmctld ;;
    start-controller) start_controller; wait_until_up ;;
    *) echo "unknown action '$action'" >&2; exit 2 ;;
esac
