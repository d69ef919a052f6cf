// Defects put into the text of an OpenRadioss deck: each has to be found.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "base/errors.h"
#include "deck_models.h"
#include "exchange/openradioss_reader.h"
#include "exchange/openradioss_writer.h"

namespace knitmech::exchange {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

struct Texts {
  std::string starter, engine;
};

Texts texts_of(knit::Structure structure) {
  model::Case input = fabric_case(3, 2);
  input.fabric.structure = structure;
  const model::Model model = model::build_model(input);
  std::ostringstream starter, engine;
  write_openradioss_starter(starter, model, {});
  write_openradioss_engine(engine, model, {});
  return {starter.str(), engine.str()};
}

/// Reads and checks both decks.
void look_at(const Texts& texts) {
  std::istringstream starter_in(texts.starter), engine_in(texts.engine);
  const OpenRadiossDeck starter = read_openradioss_starter(starter_in, "deck");
  check_openradioss(starter, read_openradioss_engine(engine_in, "engine"), "deck");
}

struct Defect {
  const char* was;  ///< in the starter; its first occurrence
  const char* is;
  const char* message;
};

class OpenRadiossDefects : public testing::TestWithParam<Defect> {};

TEST_P(OpenRadiossDefects, AreFound) {
  Texts texts = texts_of(knit::Structure::tied);
  const auto at = texts.starter.find(GetParam().was);
  ASSERT_NE(at, std::string::npos) << GetParam().was;
  texts.starter.replace(at, std::string(GetParam().was).size(), GetParam().is);
  EXPECT_THAT([&] { look_at(texts); }, ThrowsMessage<InputError>(HasSubstr(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(
    Starter, OpenRadiossDefects,
    testing::Values(
        // Columns
        Defect{"                1700                0.39", "               1700                 0.39 1",
               "behind column 40"},
        Defect{"                1700                0.39", "              1700 0                0.39",
               "\"1700 0\" is not a number"},
        Defect{"        10        10        11", "         10        10        11", "stands behind column 40"},
        Defect{"   000 000         0", "   000000          0", "no hinges"},
        Defect{"   101 111", "   10 1111", "the code of /BCS"},
        // Cards that are missing or too many
        Defect{"       000                             0                   0                   0                   0\n",
               "", "/INTER/TYPE11/1 has 5 lines here and needs 6"},
        Defect{"/LINE/PART/1\nyarns\n         1\n", "/LINE/PART/1\nyarns\n", "the group 1 is empty"},
        Defect{"/END", "/TITLE\nend", "does not end with /END"},
        Defect{"/PART/1", "/PART", "/PART needs a number at its end"},
        Defect{"/PART/1", "/PART/one", "the part 1 does not exist"},
        // What is not there, or twice
        Defect{"/PROP/BEAM/1", "/PROP/BEAM/2", "the property 1 does not exist"},
        Defect{"/MAT/ELAST/1", "/MAT/ELAST/3", "the material 1 does not exist"},
        Defect{"\n/BEAM/1\n", "\n/BEAM/2\n", "the part 2 does not exist"},
        Defect{"/LINE/PART/1", "/LINE/PART/2", "the line 1 does not exist"},
        Defect{"/FUNCT/1", "/FUNCT/2", "the function 1 does not exist"},
        Defect{"/GRNOD/NODE/2", "/GRNOD/NODE/7", "the node group 2 does not exist"},
        Defect{"/GRNOD/NODE/2", "/GRNOD/NODE/1", "defines the number 1 a second time"},
        Defect{"         1         1         2       ", "         1         1       999       ",
               "the node 999 does not"},
        Defect{"         1         1         2       ", "         1         2         2       ", "has a node twice"},
        Defect{"         2         2         3       ", "         1         2         3       ", "a second time"},
        // Mechanics
        Defect{"   101 111", "   111 111", "is driven along Y and held"},
        Defect{"         1         Y", "         1         W", "a grip moves along X, Y or Z"},
        Defect{"         2         0\n#              Stfac", "         1         0\n#              Stfac",
               "friction that sticks needs Iform 2"},
        Defect{"/MPC/1\ntie 1 x\n#  node_ID      Idof   skew_ID               alpha\n",
               "/MPC/1\ntie 1 x\n         1         1         0                 0.5\n", "is constrained and held"}));

TEST(OpenRadiossEngineDefects, AreFound) {
  const Texts good = texts_of(knit::Structure::basic);
  const auto with = [&](const std::string& was, const std::string& is) {
    Texts texts = good;
    texts.engine.replace(texts.engine.find(was), was.size(), is);
    return [texts] { look_at(texts); };
  };
  EXPECT_NO_THROW(look_at(good));
  EXPECT_THAT(with("/RUN/fabric", "/RUN/jersey"),
              ThrowsMessage<InputError>(HasSubstr("the starter names the run \"fabric\", the engine \"jersey\"")));
  EXPECT_THAT(with("/VERS/2018", "/VERS/2022"), ThrowsMessage<InputError>(HasSubstr("the engine of 2022")));
  EXPECT_THAT(with("/DT\n0.8 0", "/DT\n0.8"), ThrowsMessage<InputError>(HasSubstr("/DT needs 2 numbers")));
}

TEST(OpenRadiossReader, ListsKeywordsThatItDoesNotKnow) {
  Texts texts = texts_of(knit::Structure::basic);
  texts.starter.insert(texts.starter.find("/END"), "/RBODY/1\nplate\n         1\n");
  std::istringstream in(texts.starter);
  const OpenRadiossDeck deck = read_openradioss_starter(in, "deck");
  ASSERT_EQ(deck.unread.size(), 1U);
  EXPECT_EQ(deck.unread[0].keyword, "/RBODY/1");
}

}  // namespace
}  // namespace knitmech::exchange
