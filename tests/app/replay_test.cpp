#include "app/input/replay.hpp"

#include <unistd.h>

#include "core/base/files/file_io.hpp"
#include "core/document/format/format.hpp"
#include "tests/support/must.hpp"

namespace hariko {
namespace {

using Kind = InputEvent::Kind;
namespace fs = std::filesystem;

class ReplayFile : public ::testing::Test {
 protected:
  fs::path path_ = fs::temp_directory_path() / ("hariko-replay-test-" + std::to_string(getpid()) + ".jsonl");
  ~ReplayFile() override { fs::remove(path_); }
};

std::vector<std::vector<InputEvent>> all_kinds() {
  return {{{.kind = Kind::move, .x = 12.25, .y = 700},
           {.kind = Kind::button, .code = 2, .down = true, .modifiers = 1}},
          {{.kind = Kind::leave}},
          {{.kind = Kind::wheel, .x = -1, .y = 0.5}},
          {{.kind = Kind::key, .code = 90, .meant = 89, .down = true, .repeated = true, .modifiers = 2},
           {.kind = Kind::text, .code = 0x5f35}},
          {{.kind = Kind::focus, .down = true}},
          {{.kind = Kind::size, .x = 800, .y = 600}},
          {{.kind = Kind::drop, .paths = {"/tmp/a b.obj", "/tmp/\xe5\xbc\xb5.obj"}}},
          {{.kind = Kind::close}}};
}

TEST_F(ReplayFile, GivesBackTheSessionThatItBeganWith) {
  ReplayStart start{800, 600, 1, {}};
  start.session = {write_document(Document()), "Vase \xff \"1\".hariko", true, "{\"theme\":\"light\"}"};
  {
    ReplayRecorder recorder(path_, start, 0);
    ASSERT_TRUE(recorder.ok());
    recorder.finish(1, Document(), 0);
  }
  const auto replay = test::must(Replay::read(path_));
  ASSERT_TRUE(replay->start.session.has_value());
  EXPECT_EQ(replay->start.session->document, start.session->document);
  EXPECT_EQ(replay->start.session->name, "Vase \xef\xbf\xbd \"1\".hariko");
  EXPECT_TRUE(replay->start.session->dirty);
  EXPECT_EQ(replay->start.session->settings, start.session->settings);
}

TEST(ReplayPlayer, SkipsPausesOnlyWhileNothingIsLeftToDo) {
  Replay replay;
  replay.steps = {{5, {{.kind = Kind::move, .x = 1}}, false}, {5.1, {{.kind = Kind::move, .x = 2}}, false}};
  ReplayPlayer player(replay, true);
  EXPECT_TRUE(player.advance(0.01, false).empty()) << "the program is busy";
  EXPECT_EQ(player.advance(0.01, true).size(), 1U);
  EXPECT_EQ(player.now(), 5);
  EXPECT_TRUE(player.advance(0.01, false).empty()) << "what follows closely keeps its distance";
  EXPECT_EQ(player.advance(0.2, false).size(), 1U);
  ReplayPlayer patient(replay);
  EXPECT_TRUE(patient.advance(0.01, true).empty());
}

TEST_F(ReplayFile, GivesBackWhatWasRecorded) {
  const auto batches = all_kinds();
  {
    ReplayRecorder recorder(path_, {1000, 700, 1.5, {path_.parent_path() / "samples" / "cube.hariko"}}, 10);
    ASSERT_TRUE(recorder.ok());
    double now = 10;
    for (const auto& batch : batches) recorder.batch(now += 0.25, batch);
    recorder.idle(now);
    recorder.idle(now + 1);  // only once
    recorder.finish(now + 1, Document(), 3);
  }
  const auto replay = test::must(Replay::read(path_));
  const Replay& read = replay.value();
  EXPECT_EQ(read.start.width, 1000);
  EXPECT_EQ(read.start.height, 700);
  EXPECT_EQ(read.start.scale, 1.5);
  ASSERT_EQ(read.start.files.size(), 1U);
  EXPECT_EQ(read.start.files[0], fs::absolute(path_).parent_path() / "samples" / "cube.hariko");
  ASSERT_EQ(read.steps.size(), batches.size() + 2);
  for (std::size_t i = 0; i < batches.size(); ++i) {
    EXPECT_EQ(read.steps[i].batch, batches[i]) << i;
    EXPECT_EQ(read.steps[i].time, 0.25 * double(i + 1));
  }
  EXPECT_TRUE(read.steps[batches.size()].waits_for_idle);
  EXPECT_EQ(read.undo_steps, 3U);
  EXPECT_EQ(read.document, write_document(Document()));
}

/// Documents are compared as the present format writes them, so that a recording outlives the format.
TEST(ReplayEnd, DocumentsOfEveryFormatAreCompared) {
  Replay replay;
  replay.document = R"({"format": "hariko", "version": 2, "unit": "cm", "next_object_id": 1, "objects": []})";
  const auto centimetres = test::must(read_document(replay.document));
  EXPECT_EQ(other_document(replay, centimetres.value()), std::nullopt);
  const auto difference = other_document(replay, Document());
  ASSERT_TRUE(difference.has_value());
  EXPECT_NE(difference->find("another one"), std::string::npos) << *difference;
  EXPECT_NE(difference->find("cm"), std::string::npos) << *difference;
  replay.document = "no document at all";
  ASSERT_TRUE(other_document(replay, Document()).has_value());
  replay.document = "3490dd582ff8a575";
  EXPECT_EQ(other_document(replay, Document()), std::nullopt);
}

/// The frame in which a recording begins is older than the recording.
TEST_F(ReplayFile, NothingIsEarlierThanTheBeginning) {
  {
    ReplayRecorder recorder(path_, {1000, 700, 1.5, {}}, 10);
    recorder.idle(9.998);
    recorder.finish(10.5, Document(), 0);
  }
  const auto replay = test::must(Replay::read(path_));
  EXPECT_EQ(replay->steps.at(0).time, 0);
}

TEST_F(ReplayFile, BrokenFilesAreRefusedWithTheirLine) {
  const std::string start = R"({"hariko_replay":1,"width":800,"height":600,"files":[]})";
  const auto refused = [&](const std::string& text, const std::string& part) {
    ASSERT_TRUE(write_file_atomic(path_, text).ok());
    const auto replay = Replay::read(path_);
    ASSERT_FALSE(replay.ok()) << text;
    EXPECT_EQ(replay.error().code, e_replay_read);
    EXPECT_NE(replay.error().text.find(part), std::string::npos) << replay.error().text;
  };
  refused("", "no end");
  refused("nonsense", "line 1");
  refused(R"({"hariko_replay":2,"width":800,"height":600,"files":[]})", "version 2");
  refused(start + "\n" + R"({"t":1,"events":[{"kind":"jump"}]})", "line 2");
  refused(start + "\n" + R"({"t":1,"idle":true})" + "\n" + R"({"t":0.5,"idle":true})", "line 3");
  refused(start + "\n" + R"({"t":1,"events":[]})", "no end");
}

TEST(ReplayPlayer, StandsStillWhereTheProgramIsSlow) {
  Replay replay;
  replay.steps = {{0.5, {{.kind = Kind::button, .code = 0, .down = true}}, false},
                  {0.7, {{.kind = Kind::button, .code = 0, .down = false}}, false},
                  {1.0, {}, true},
                  {1.1, {{.kind = Kind::key, .code = 65}}, false},
                  {1.2, {}, true}};
  ReplayPlayer player(replay);
  EXPECT_TRUE(player.advance(0.4, true).empty());
  EXPECT_EQ(player.advance(5, true).size(), 1U);  // a frame of five seconds
  EXPECT_EQ(player.now(), 0.5);
  EXPECT_EQ(player.advance(5, true).size(), 1U);
  EXPECT_EQ(player.now(), 0.7) << "what was a double click stays one";
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(player.advance(1, false).empty());
  EXPECT_FALSE(player.all_played());
  EXPECT_TRUE(player.advance(0, true).empty());
  const double waited = player.now();
  EXPECT_EQ(player.advance(9, true).size(), 1U);
  EXPECT_NEAR(player.now(), waited + 0.1, 1e-12);
  EXPECT_TRUE(player.all_played());
  player.advance(1, true);
  EXPECT_FALSE(player.finished());
  player.advance(1, true);
  EXPECT_TRUE(player.finished());
}

TEST(ReplayPlayer, GivesUpOnAProgramThatNeverRests) {
  Replay replay;
  replay.steps = {{0, {}, true}};
  ReplayPlayer player(replay);
  for (double waited = 0; waited <= ReplayPlayer::longest_wait + 1 && !player.stuck(); ++waited)
    player.advance(1, false);
  EXPECT_TRUE(player.stuck());
  EXPECT_FALSE(player.finished());
}

}  // namespace
}  // namespace hariko
