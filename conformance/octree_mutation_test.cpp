// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Each rule of the octree bitstream is broken in the plain coder, and the suites must notice.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "conformance/octree_test_cases.h"
#include "conformance/octree_test_mutations.h"
#include "conformance/rules.h"

namespace afx::conformance {
namespace {

constexpr size_t kMostBytes = 10000;     // of a stream that is judged here
constexpr uint64_t kMostNodes = 200000;  // beyond any of those
constexpr size_t kNamed = 3;

OctreeCoder plain_coder(const Rules& rules) {
  return {[&](const std::vector<uint8_t>& data, unsigned levels) {
            return codec::plain::decode_stream(data, levels, kMostNodes, rules);
          },
          [&](const Stream& values) { return codec::plain::encode_stream(values, rules); }};
}

/// Of the two suites that are made for it; the model's streams show no rule that these do not.
const std::vector<OctreeCase>& small_cases() {
  static const std::vector<OctreeCase> kCases = [] {
    std::vector<OctreeCase> small;
    for (const char* suite : {"octree-rules", "octree-rejects"})
      for (OctreeCase& one : read_octree_cases(suite))
        if (one.data.size() <= kMostBytes) small.push_back(std::move(one));
    return small;
  }();
  return kCases;
}

/// The names of the cases that do not hold.
std::vector<std::string> caught_by(const Rules& rules) {
  std::vector<std::string> names;
  for (const OctreeCase& one : small_cases())
    if (first_failure(one, plain_coder(rules))) names.push_back(one.info.name);
  return names;
}

std::string row(const Mutation& mutation, const std::vector<std::string>& names) {
  std::string cells = "| " + mutation.rule + " | " + mutation.text + " | ";
  for (size_t i = 0; i < std::min(kNamed, names.size()); ++i)
    cells += (i == 0 ? "" : ", ") + names[i];
  return cells + " | " + std::to_string(names.size()) + " |\n";
}

std::string table_of_the_repository() {
  std::ifstream in(AFX_SOURCE_DIR "/conformance/suites/octree-mutations.md");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The ids of all rules.
std::set<std::string> all_rules() {
  std::set<std::string> ids;
  const auto rules = read_rules(AFX_SOURCE_DIR "/conformance/suites/rules/octree.json");
  if (!rules.ok()) return ids;
  for (const Rule& rule : rules.value().rules) ids.insert(rule.id);
  return ids;
}

TEST(OctreeMutation, NoCaseFailsByTheText) {
  EXPECT_EQ(caught_by(codec::plain::text_rules()), std::vector<std::string>{});
}

TEST(OctreeMutation, EveryBrokenRuleIsCaughtByTheCasesOfTheTable) {
  std::string table =
      "# What catches a broken rule\n\n"
      "`octree_mutation_test.cpp` breaks each rule of `rules/octree.json` in a plain coder and "
      "runs "
      "the small cases of\n`octree-rules` and `octree-rejects`. This is its table.\n\n"
      "| rule | instead | caught by | cases |\n| --- | --- | --- | --- |\n";
  for (const Mutation& mutation : octree_mutations()) {
    Rules rules;
    mutation.apply(rules);
    const std::vector<std::string> names = caught_by(rules);
    EXPECT_FALSE(names.empty()) << mutation.rule << ": " << mutation.text;
    table += row(mutation, names);
  }
  table += "\n## Rules that are not broken here\n\n| rule | why |\n| --- | --- |\n";
  for (const Unbroken& rule : octree_rules_without_mutation())
    table += "| " + rule.rule + " | " + rule.why + " |\n";
  if (table == table_of_the_repository()) return;
  const std::string made = std::filesystem::current_path() / "octree-mutations.md";
  std::ofstream(made) << table;
  ADD_FAILURE() << "conformance/suites/octree-mutations.md is not the table: " << made << " is";
}

TEST(OctreeMutation, EveryRuleHasAMutationOrAReasonWhyNot) {
  std::set<std::string> broken;
  for (const Mutation& mutation : octree_mutations()) broken.insert("octree." + mutation.rule);
  std::set<std::string> known = broken;
  for (const Unbroken& rule : octree_rules_without_mutation()) {
    EXPECT_FALSE(broken.contains("octree." + rule.rule)) << rule.rule;
    known.insert("octree." + rule.rule);
  }
  EXPECT_EQ(known, all_rules());
}

TEST(OctreeMutation, EveryBrokenRuleIsCoveredByACase) {
  std::set<std::string> covered;
  for (const char* suite : {"octree-model", "octree-rules", "octree-rejects"})
    for (const OctreeCase& one : read_octree_cases(suite))
      covered.insert(one.info.covers.begin(), one.info.covers.end());
  for (const Mutation& mutation : octree_mutations())
    EXPECT_TRUE(covered.contains("octree." + mutation.rule)) << mutation.rule;
}

bool choose_the_same(const codec::plain::Symmetries& a, const codec::plain::Symmetries& b) {
  for (unsigned s = 0; s < 256; ++s)
    if (a.number[s] != b.number[s] || a.child[a.symmetry[s]] != b.child[b.symmetry[s]])
      return false;
  return true;
}

// Why 5.permutation is not broken, and not all orders of the permutations are.
TEST(OctreeMutation, SomeOrdersOfThePermutationsChooseTheSameSymmetries) {
  using codec::plain::make_symmetries;
  const auto text = codec::plain::text_symmetries();
  const auto exchanged = [](size_t a, size_t b) {
    return make_symmetries({.permutations = permutations_with_exchanged(a, b)});
  };
  EXPECT_TRUE(choose_the_same(*text, *make_symmetries({.inverse_permutation = true})));
  EXPECT_TRUE(choose_the_same(*text, *exchanged(1, 2)));
  EXPECT_TRUE(choose_the_same(*text, *exchanged(3, 4)));
  EXPECT_FALSE(choose_the_same(*text, *exchanged(2, 4)));
}

/// Of the cases that say they cover a rule one at least catches it where it is broken.
TEST(OctreeMutation, SomeCaseThatCoversARuleCatchesItBroken) {
  for (const Mutation& mutation : octree_mutations()) {
    Rules rules;
    mutation.apply(rules);
    const OctreeCoder coder = plain_coder(rules);
    const std::string id = "octree." + mutation.rule;
    EXPECT_TRUE(std::any_of(small_cases().begin(), small_cases().end(),
                            [&](const auto& one) {
                              return std::count(one.info.covers.begin(), one.info.covers.end(),
                                                id) > 0 &&
                                     first_failure(one, coder);
                            }))
        << id << ": " << mutation.text;
  }
}

}  // namespace
}  // namespace afx::conformance
