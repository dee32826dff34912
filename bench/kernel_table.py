#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the benchmarks of kernels and prints their rates as the Markdown table of docs/notes/performance.md.

    kernel_table.py PROGRAM [--repetitions N] [--filter REGEX]

PROGRAM is the built bench/kernels. Kernels alternate, so that a slow moment of the machine affects all of
them alike. The fastest repetition counts.
"""

import argparse
import json
import subprocess

PLAIN = "plain sweep in doubles, degree 4, inside"
OURS = "manifold sweep, degree 4, inside"


def results_of(program, repetitions, pattern):
    """Returns the output of Google Benchmark: its context, and one entry for each kernel and repetition."""
    command = [program, "--benchmark_format=json", f"--benchmark_repetitions={repetitions}",
               "--benchmark_enable_random_interleaving=true", f"--benchmark_filter={pattern}"]
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)


def fastest(entries):
    """Returns {kernel: its entry with the highest rate}, in the order of the program."""
    best = {}
    for entry in sorted(entries, key=lambda entry: entry["family_index"]):
        if entry["run_type"] != "iteration":
            continue
        name = entry["run_name"]
        if name not in best or entry["items_per_second"] > best[name]["items_per_second"]:
            best[name] = entry
    return best


def print_table(kernels):
    print("| kernel | million items a second | flops an item | bytes an item | share of the limit | limit |\n"
          "|---|---|---|---|---|---|")
    for name, entry in kernels.items():
        print(f"| {name} | {entry['items_per_second'] / 1e6:.3g} | {entry['flops_per_item']:.0f} | "
              f"{entry['bytes_per_item']:.0f} | {100 * entry['share_of_limit']:.1f} % | {entry['label']} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the built bench/kernels")
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--filter", default=".", help="a regular expression: kernels of other names are left out")
    arguments = parser.parse_args()
    results = results_of(arguments.program, arguments.repetitions, arguments.filter)
    context = results["context"]
    kernels = fastest(results["benchmarks"])
    print(f"One core copies {context['copy_gigabytes_per_second']} GB a second, read and written together, and does "
          f"{context['multiply_add_gigaflops']} Gflop a second in multiply-adds of "
          f"{context['vector_doubles']} doubles.\n")
    print_table(kernels)
    if PLAIN in kernels and OURS in kernels:
        ratio = kernels[OURS]["items_per_second"] / kernels[PLAIN]["items_per_second"]
        print(f"\nInside cells the library sweeps {ratio:.2f} times as fast as the plain loop.")


if __name__ == "__main__":
    main()
