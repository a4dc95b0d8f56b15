// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper_rows.hpp"

namespace stickslip {
namespace {

constexpr NormalLaw kUnilateral = NormalLaw::kUnilateral;

}  // namespace

const ForceTable& table_1() {
  static const ForceTable table{
      "Table I: the grasp of Fig. 1",
      "fig1.json",
      {{"(0, 0, 0)", "0", "Yes", {{"(0, 0)", "(0, 0)", "(0, 0)"}, "(0, 0, 0)"}, {}},
       {"(0, 0, 0)", "1", "Yes", {{"(1, -0.5)", "(1, 0)", "(1, 0.5)"}, "(0, 0, 0)"}, {}},
       {"(0, -1, 0)", "0", "Yes", {{"(0, 0)", "(1, 0)", "(0, 0)"}, "(0, -1, 0)"}, {}},
       {"(0, -2, 0)", "0", "Yes", {{"(0, 0)", "(2, 0)", "(0, 0)"}, "(0, -2, 0)"}, {}},
       {"(0, 1, 0)", "0", "No", {}, {}},
       {"(0, 1, 0)", "1", "Yes", {{"(1, -0.5)", "(0, 0)", "(1, 0.5)"}, "(0, 1, 0)"}, {}},
       {"(0, 1.1, 0)", "1", "No", {}, {}}}};
  return table;
}

const ForceTable& table_3() {
  static const Correction forces_misprinted{
      false,
      "f1, f3",
      {{"(1, 0.5)", "(0, 0)", "(1, 0.5)", "(0, 0)"}, "(0, -1, 1)"},
      "misprint: f1 and f3 are (1, 0.5); compare the row below"};
  static const Correction twist_misprinted{
      true,
      "",
      {{"(0.75, -0.375)", "(1.25, -0.625)", "(0.75, -0.375)", "(1.25, -0.625)"},
       "(0, 0.25, -0.25)"},
      "d was meant to mirror the row above; any (0, y, -0.25) with |y| <= 0.25 serves"};
  static const ForceTable table{
      "Table III: the grasp of Fig. 4",
      "fig4.json",
      {{"(0, 0, 0)", "0", "Yes", {{"(0, 0)", "(0, 0)", "(0, 0)", "(0, 0)"}, "(0, 0, 0)"}, {}},
       {"(0, 0, 0)", "1", "Yes", {{"(1, 0)", "(1, 0)", "(1, 0)", "(1, 0)"}, "(0, 0, 0)"}, {}},
       {"(0, 2, 0)", "0", "No", {}, {}},
       {"(0, -2, 0)", "0", "No", {}, {}},
       {"(0, 2, 0)",
        "1",
        "Yes",
        {{"(1, -0.5)", "(1, -0.5)", "(1, 0.5)", "(1, 0.5)"}, "(0, 0, 0)"},
        {}},
       {"(0, -2, 0)",
        "1",
        "Yes",
        {{"(1, 0.5)", "(1, 0.5)", "(1, -0.5)", "(1, -0.5)"}, "(0, 0, 0)"},
        {}},
       {"(0, 0, 3)",
        "0",
        "Yes",
        {{"(0, 0.5)", "(0, 0)", "(0, 0.5)", "(0, 0)"}, "(0, -1, 1)"},
        forces_misprinted},
       {"(0, 0, -3)",
        "0",
        "Yes",
        {{"(0, 0)", "(1, -0.5)", "(0, 0)", "(1, -0.5)"}, "(0, 1, -1)"},
        {}},
       {"(0, 0, 3)",
        "1",
        "Yes",
        {{"(1.25, 0.625)", "(0.75, 0.375)", "(1.25, 0.625)", "(0.75, 0.375)"},
         "(0, -0.25, 0.25)"},
        {}},
       {"(0, 0, -3)",
        "1",
        "Yes",
        {{"(0.75, -0.375)", "(1.25, -0.625)", "(0.75, -0.375)", "(1.25, -0.625)"},
         "(0, 0.025, -0.25)"},
        twist_misprinted}}};
  return table;
}

const ClaimGroup& table_3_without_detachment() {
  static const ClaimGroup group{
      "Remark on Table III: these two rows need contacts that open. By the literal Eqs. 2 and "
      "4:",
      "fig4.json",
      NormalLaw::kBilateral,
      {{"0", "(0, 0, 3)", false}, {"0", "(0, 0, -3)", false}}};
  return group;
}

const std::vector<CountColumn>& table_2() {
  static const std::vector<CountColumn> columns{
      {2, "10", "9"},    {3, "26", "27"},   {4, "50", "51"},   {5, "82", "83"},
      {6, "122", "123"}, {7, "170", "171"}, {8, "226", "227"}, {9, "290", "291"}};
  return columns;
}

const std::vector<FigureCounts>& figure_counts() {
  static const std::vector<FigureCounts> counts{
      {"Fig. 1, three distinct circles", "fig1.json", {3, "26", "27"}},
      {"Fig. 4, two distinct circles for four contacts", "fig4.json", {4, "10", "9"}}};
  return counts;
}

const std::vector<ClaimGroup>& claims() {
  static const std::vector<ClaimGroup> groups{
      {"Fig. 3 as it stands in the file; linear tangential springs would say unstable",
       "fig3.json",
       kUnilateral,
       {{{}, {}, true}}},
      {"Fig. 4 without preload: no (0, w_y, 0) is resisted",
       "fig4.json",
       kUnilateral,
       {{"0", "(0, 2, 0)", false},
        {"0", "(0, -2, 0)", false},
        {"0", "(0, 1e-18, 0)", false},
        {"0", "(0, -1e-18, 0)", false}}},
      {"Fig. 4 with preload: resisted iff |w_y| <= 4 mu = 2",
       "fig4.json",
       kUnilateral,
       {{"1", "(0, 2, 0)", true},
        {"1", "(0, -2, 0)", true},
        {"1", "(0, 2.000000000000000001, 0)", false},
        {"1", "(0, -2.000000000000000001, 0)", false}}},
      {"Fig. 1: any push into contact 2 is resisted, preloaded or not",
       "fig1.json",
       kUnilateral,
       {{"0", "(0, -1e-18, 0)", true},
        {"0", "(0, -1, 0)", true},
        {"0", "(0, -1000, 0)", true},
        {"0", "(0, -1e9, 0)", true},
        {"1", "(0, -1e-18, 0)", true},
        {"1", "(0, -1, 0)", true},
        {"1", "(0, -1000, 0)", true},
        {"1", "(0, -1e9, 0)", true}}},
      {"Fig. 1: a pull away from contact 2 is resisted up to 1 with preload, never without",
       "fig1.json",
       kUnilateral,
       {{"0", "(0, 1e-18, 0)", false},
        {"1", "(0, 0.5, 0)", true},
        {"1", "(0, 1, 0)", true},
        {"1", "(0, 1.000000000000000001, 0)", false}}},
      {"Fig. 7(c): with preload the border is w_y = max(0, 1 - |w_x|/2)",
       "fig1.json",
       kUnilateral,
       {{"1", "(1, 0.5, 0)", true},
        {"1", "(1, 0.500000000000000001, 0)", false},
        {"1", "(-1, 0.5, 0)", true},
        {"1", "(-1, 0.500000000000000001, 0)", false},
        {"1", "(3, 0, 0)", true},
        {"1", "(3, 1e-18, 0)", false}}}};
  return groups;
}

}  // namespace stickslip
