# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Writes the suites of OctreeImage streams, below ../suites, whole; always the same bytes.

    python3 octree_suites.py
"""
import octree_model_cases
import octree_reject_cases
import octree_rule_cases
from suite_writer import AFX, Suite

RULES = ["../rules/octree.json"]


def write(suite, cases):
    cases.add_all(suite)
    suite.close()


if __name__ == "__main__":
    write(Suite("octree-model", "OctreeImage streams of another program", RULES,
                octree_model_cases.ORIGINS, fresh=False), octree_model_cases)
    write(Suite("octree-rules", "OctreeImage streams that touch one rule each", RULES, AFX),
          octree_rule_cases)
    write(Suite("octree-rejects", "OctreeImage streams that must not be accepted", RULES, AFX),
          octree_reject_cases)
