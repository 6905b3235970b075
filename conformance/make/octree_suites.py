# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Writes the suites of OctreeImage streams, below ../suites, whole; always the same bytes.

    python3 octree_suites.py
"""
import octree_coding_cases
import octree_model_cases
import octree_reject_cases
import octree_rule_cases
from octree_cases import Cases
from suite_writer import AFX, Suite

RULES = ["../rules/octree.json"]


if __name__ == "__main__":
    model = Suite("octree-model", "OctreeImage streams of another program", RULES, octree_model_cases.ORIGINS,
                  fresh=False)
    octree_model_cases.add_all(model)
    model.close()
    rules = Suite("octree-rules", "OctreeImage streams that touch one rule each", RULES, AFX)
    octree_rule_cases.add_all(Cases(rules))
    octree_coding_cases.add_all(Cases(rules))
    rules.close()
    rejects = Suite("octree-rejects", "OctreeImage streams that must not be accepted", RULES, AFX)
    octree_reject_cases.add_all(rejects)
    rejects.close()
