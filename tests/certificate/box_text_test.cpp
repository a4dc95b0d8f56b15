// SPDX-License-Identifier: GPL-3.0-or-later
// The syntax of box certificates, to the letter (FORMAT.md, section 6). Whether proofs hold is
// for the checkers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

GraspFile file_of(const Vector2& normal, const Rational& preload) {
  return {LoadedGrasp{Grasp({{{0, 0}, normal, 1, 1, preload}}), {0, Rational(-1, 2), 0}}};
}

Question question_of(const GraspFile& file, const char* tolerances) {
  QuestionOptions options;
  options.uncertain = parse_tolerances(tolerances);
  return ask(file, options);
}

Trees every_node() {
  return {PartSplit{Parameter::kFriction, 0, Rational(1, 2)},
          PartSplit{Parameter::kWrench, 2, -3},
          SlipSplit{ContactId(0)},
          SeparationSplit{ContactId(0)},
          PlaneCut{{1, -2, 3, 4, 0}},
          TwistLeaf{{0, -1, 2}}};
}

constexpr const char* kNodes = R"( "tree": [
  ["part","friction",0,"1/2"],
  ["part","wrench",2,-3],
  ["slip",0],
  ["separation",0],
  ["plane",1,-2,3,4],
  ["leaf",0,-1,2]])";

TEST(BoxCertificate, Unstable) {
  const Question question =
      question_of(file_of({0, 1}, 1),
                  "friction=10%,stiffness=1/3%,preload=1/10,position=2,normal=0.0175,wrench=0");
  EXPECT_EQ(certificate_text(question, Unstable{every_node()}, "us", 256),
            std::string(R"({"format": "stickslip-certificate/2",
 "producer": "us",
 "question": {"contacts": 1, "wrench": [0,"-1/2",0], "normal_law": "unilateral", )"
                        R"("uncertain": {"friction": "10%", "stiffness": "1/3%", )"
                        R"("preload": "1/10", "position": 2, "normal": "7/400", "wrench": 0}},
 "verdict": "unstable",
)") + kNodes + "}\n");
}

TEST(BoxCertificate, Stable) {
  const std::vector<RationalRow> walls{{1, 0, 0}, {0, Rational(1, 2), 0}, {0, 0, -3}};
  const std::vector<RationalRow> direction{{1, 2, 3}, {4, 5, 6}, {7, 8, Rational(9, 2)}};
  const DegreeProof proof{ConvexBody{{0, 1, Rational(2, 3)}, false, walls}, direction,
                          every_node()};
  const RestProof rest{{{ContactId(0), {Rational(1, 2)}}},
                       {{ContactId(0), {{1}, {Rational(-1, 2)}, {0}}}},
                       {0, 2, 1}};
  const StabilityProof parts{PartSplit{Parameter::kTurn, 0, 0}, proof,
                             PartSplit{Parameter::kTurn, 0, Rational(1, 18)}, rest,
                             DegreeProof{ConvexBody{{0, 0, 0}, false, walls}, walls, {}}};
  const std::string text =
      certificate_text(question_of(file_of({0, 1}, 1), "normal=1/9"), Stable{parts}, "us");
  EXPECT_THAT(text, HasSubstr(std::string(R"("uncertain": {"normal": "1/9"}},
 "verdict": "stable",
 "parts": [
  ["part","turn",0,0],
  {"twist": [0,1,"2/3"],
 "walls": [[1,0,0],[0,"1/2",0],[0,0,-3]],
 "direction": [[1,2,3],[4,5,6],[7,8,"9/2"]],
)") + kNodes + R"(},
  ["part","turn",0,"1/18"],
  {"rest": [[0,"1/2"]],
 "answers": [[0,[1,"-1/2",0]]],
 "reach": [0,2,1]},
  {"twist": [0,0,0],
 "walls": [[1,0,0],[0,"1/2",0],[0,0,-3]],
 "direction": [[1,0,0],[0,"1/2",0],[0,0,-3]],
 "tree": []}]}
)"));
}

TEST(BoxCertificate, NamesOfParameters) {
  const Question question = question_of(file_of({0, 1}, 1), "friction=1%");
  const struct {
    Parameter parameter;
    const char* name;
  } all[] = {{Parameter::kX, "x"},
             {Parameter::kY, "y"},
             {Parameter::kTurn, "turn"},
             {Parameter::kFriction, "friction"},
             {Parameter::kPreload, "preload"},
             {Parameter::kStiffness, "stiffness"},
             {Parameter::kWrench, "wrench"}};
  for (const auto& [parameter, name] : all) {
    const Trees tree{PartSplit{parameter, 0, 1}};
    EXPECT_THAT(certificate_text(question, Unstable{tree}, "us"),
                HasSubstr(std::string("[\"part\",\"") + name + "\",0,1]"));
  }
}

TEST(BoxCertificate, BitsWhereALengthIsIrrational) {
  const auto text = [](const Question& question, unsigned bits) {
    return certificate_text(question, Unstable{every_node()}, "us", bits);
  };
  const Question rational = question_of(file_of({3, 4}, 1), "friction=1%");
  const Question irrational = question_of(file_of({1, 1}, 1), "friction=1%");
  const Question alone = ask(file_of({1, 1}, 1), {});
  const Question free = question_of(file_of({1, 1}, 0), "friction=1%");
  for (const Question* question : {&irrational, &alone}) {
    EXPECT_THAT(text(*question, 256),
                HasSubstr("},\n \"bits\": 256,\n \"verdict\": \"unstable\""));
    EXPECT_THAT(text(*question, 128), Not(HasSubstr("bits")));
  }
  EXPECT_THAT(text(alone, 128), Not(HasSubstr("uncertain")));
  EXPECT_THAT(text(rational, 256), Not(HasSubstr("bits")));
  EXPECT_THAT(text(free, 256), Not(HasSubstr("bits")));
}

TEST(BoxCertificate, UncertainComponentsOfTheWrenchAreTwoNumbers) {
  GraspFile file = file_of({0, 1}, 1);
  GraspBox box = file.content.as_box();
  box.wrench[1] = {-1, Rational(-1, 2)};
  file.content = std::move(box);
  EXPECT_THAT(certificate_text(question_of(file, "wrench=100%"), Unstable{every_node()}, "us"),
              HasSubstr(R"("wrench": [0,[-1,"-1/2"],0])"));
}

TEST(BoxCertificate, AnOrdinaryOneRepeatsTheTolerances) {
  const Question question = question_of(file_of({0, 1}, 1), "friction=0");
  ASSERT_EQ(question.box(), nullptr);
  EXPECT_THAT(certificate_text(question, Unstable{{TwistLeaf{Row(3)}}}, "us"),
              HasSubstr(R"("normal_law": "unilateral", "uncertain": {"friction": 0}})"));
}

TEST(BoxCertificate, WhatHasNone) {
  const Question box = question_of(file_of({0, 1}, 1), "friction=1%");
  const Question grasp = ask(file_of({0, 1}, 1), {});
  const LoadedGrasp loaded = file_of({0, 1}, 1).loaded();
  EXPECT_THROW(certificate_text(box, Fragile{box_of(loaded), box_of(loaded)}, "us"),
               ContractError);
  EXPECT_THROW(certificate_text(box, Undecided{"a limit"}, "us"), ContractError);
  EXPECT_THROW(certificate_text(grasp, Stable{StabilityProof{}}, "us"), ContractError);
  EXPECT_THROW(certificate_text(box, Stable{Witness{}}, "us"), ContractError);
}

}  // namespace
}  // namespace stickslip
