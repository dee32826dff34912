#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs crossgrain-mpi on four hosts that are network namespaces of this machine, joined by a bridge; as root.
#
#   hosts_in_namespaces.sh RATE PROGRAM ARGUMENTS...     RATE such as 1gbit, or "none" for no limit
#
# Delay is not simulated: the kernel here has no netem.
set -euo pipefail

rate=$1
shift
hosts=4
agent=$(mktemp)

remove() {
  for h in $(seq $hosts); do ip netns del "cgh$h" 2>/dev/null || true; done
  ip link del cgbridge 2>/dev/null || true
  rm -f "$agent"
}
remove
trap remove EXIT
agent=$(mktemp)

ip link add cgbridge type bridge
ip addr add 10.77.0.254/24 dev cgbridge
ip link set cgbridge up
for h in $(seq $hosts); do
  ip netns add "cgh$h"
  ip link add "cgv$h" type veth peer name eth0 netns "cgh$h"
  ip link set "cgv$h" master cgbridge up
  ip netns exec "cgh$h" ip addr add "10.77.0.$h/24" dev eth0
  ip netns exec "cgh$h" ip link set eth0 up
  ip netns exec "cgh$h" ip link set lo up
  if [ "$rate" != none ]; then
    ip netns exec "cgh$h" tc qdisc add dev eth0 root tbf rate "$rate" burst 256kb latency 50ms
    tc qdisc add dev "cgv$h" root tbf rate "$rate" burst 256kb latency 50ms
  fi
done

# In place of ssh: the host is the namespace of that address.
cat >"$agent" <<'END'
#!/bin/sh
host=$1
shift
exec ip netns exec "cgh${host##*.}" sh -c "$*"
END
chmod +x "$agent"

export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
mpirun -q --oversubscribe --bind-to none --mca plm_rsh_agent "$agent" --mca oob_tcp_if_include 10.77.0.0/24 \
  --mca btl tcp,self --mca btl_tcp_if_include 10.77.0.0/24 --host 10.77.0.1,10.77.0.2,10.77.0.3,10.77.0.4 -n $hosts "$@"
