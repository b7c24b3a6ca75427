// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/BackgroundWork.h"

#include "scene/basics/Error.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QThread>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <new>

namespace limn {
namespace {

using Deliver = BackgroundWork::Deliver;

class BackgroundWorkTest : public testing::Test {
protected:
  BackgroundWorkTest() {
    QObject::connect(&work, &BackgroundWork::progressed, &loop,
                     [this](double, const QString& doing) { told.push_back(doing.toStdString()); });
    QObject::connect(&work, &BackgroundWork::failed, &loop, [this](const QString& sentence) {
      failure = sentence.toStdString();
      loop.quit();
    });
  }

  // Ends the event loop once it is delivered.
  Deliver result(int value) {
    return [this, value] {
      results.push_back(value);
      loop.quit();
    };
  }

  QEventLoop loop;
  std::vector<int> results;
  std::vector<std::string> told;
  std::string failure;
  BackgroundWork work; // ends its threads before what they tell goes
};

TEST_F(BackgroundWorkTest, worksOnAThreadOfItsOwnAndDeliversOnTheOneItLivesIn) {
  QThread* worker = nullptr;
  QThread* receiver = nullptr;
  work.start([&](const Effort&) -> Deliver {
    worker = QThread::currentThread();
    return [&] {
      receiver = QThread::currentThread();
      EXPECT_FALSE(work.isRunning());
      loop.quit();
    };
  });
  EXPECT_TRUE(work.isRunning());
  loop.exec();
  EXPECT_EQ(receiver, QThread::currentThread());
  EXPECT_NE(worker, receiver);
}

TEST_F(BackgroundWorkTest, ofManyOrdersOnlyTheLastIsDelivered) {
  for (int i = 0; i < 50; ++i)
    work.start([this, i](const Effort&) { return result(i); });
  loop.exec();
  QCoreApplication::processEvents();
  EXPECT_EQ(results, std::vector<int>{49});
}

// Two that share what they work with would be two at a time.
TEST_F(BackgroundWorkTest, theNextBeginsOnceTheEndedOneIsOver) {
  int atWork = 0; // guarded by the turns themselves, which is what ThreadSanitizer judges
  int most = 0;
  for (int i = 0; i < 20; ++i) {
    std::promise<void> began;
    work.start([&, i](const Effort& effort) -> Deliver {
      most = std::max(most, ++atWork);
      began.set_value();
      while (i < 19 && !effort.isCancelled())
        std::this_thread::yield();
      --atWork;
      return result(i);
    });
    began.get_future().wait();
  }
  loop.exec();
  EXPECT_EQ(most, 1);
  EXPECT_EQ(results, std::vector<int>{19});
}

TEST_F(BackgroundWorkTest, whereAskedTheNextBeginsBesideTheOneThatDoesNotEnd) {
  BackgroundWork atOnce(nullptr, BackgroundWork::Turn::atOnce);
  std::promise<void> answer;
  atOnce.start([this, disk = answer.get_future().share()](const Effort&) {
    disk.wait();
    return result(1);
  });
  atOnce.start([this](const Effort&) { return result(2); });
  loop.exec();
  EXPECT_EQ(results, std::vector<int>{2});
  answer.set_value();
}

TEST_F(BackgroundWorkTest, cancelledWorkTellsNothingMore) {
  std::promise<void> began, isCancelled;
  work.start([&](const BackgroundWork::Line& line) {
    began.set_value();
    isCancelled.get_future().wait();
    line.report(0.5, "too late");
    line.tell([&] { results.push_back(0); });
    EXPECT_TRUE(line.effort.isCancelled());
    return result(1);
  });
  began.get_future().wait();
  work.cancel();
  EXPECT_FALSE(work.isRunning());
  isCancelled.set_value();
  work.start([this](const Effort&) { return result(2); }); // after it
  loop.exec();
  EXPECT_EQ(results, std::vector<int>{2});
  EXPECT_TRUE(told.empty());
}

TEST_F(BackgroundWorkTest, whatIsToldBeforeTheEndComesFirst) {
  work.start([&](const BackgroundWork::Line& line) {
    for (int i = 0; i < 5; ++i)
      line.tell([&, i] { results.push_back(i); });
    return result(5);
  });
  loop.exec();
  EXPECT_EQ(results, (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

// A report has the window painted: work that tells of each of its pieces must not flood it.
TEST_F(BackgroundWorkTest, passesOnWhatSaysSomethingElseAndTheRestNowAndThen) {
  std::chrono::steady_clock::duration took{};
  work.start([&](const BackgroundWork::Line& line) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 100000; ++i)
      line.report(1e-5 * i, "Reading");
    took = std::chrono::steady_clock::now() - start;
    line.report(0.0, "Counting");
    line.report(0.0, "Reading");
    return result(0);
  });
  loop.exec();
  ASSERT_GE(told.size(), 3u);
  EXPECT_LE(told.size(), static_cast<std::size_t>(took / betweenReports) + 3);
  EXPECT_EQ(told.front(), "Reading");
  EXPECT_EQ(told[told.size() - 2], "Counting");
  EXPECT_EQ(told.back(), "Reading");
}

TEST_F(BackgroundWorkTest, failuresAreSentencesAndTheNextWorkGoesOn) {
  work.start([](const Effort&) -> Deliver { throw Error(Error::Kind::input, "The file is no volume."); });
  loop.exec();
  EXPECT_EQ(failure, "The file is no volume.");
  work.start([](const Effort&) -> Deliver { throw std::bad_alloc(); });
  loop.exec();
  EXPECT_NE(failure.find("memory"), std::string::npos) << failure;
  work.start([](const Effort&) -> Deliver { throw std::runtime_error("surprise"); });
  loop.exec();
  EXPECT_EQ(failure, "An unexpected error: surprise.");
  EXPECT_FALSE(work.isRunning());
  work.start([this](const Effort&) { return result(1); });
  loop.exec();
  EXPECT_EQ(results, std::vector<int>{1});
}

TEST_F(BackgroundWorkTest, noThreadOutlivesIt) {
  std::atomic<int> ended = 0;
  for (const auto turn : {BackgroundWork::Turn::afterTheLast, BackgroundWork::Turn::atOnce}) {
    std::promise<void> began;
    {
      BackgroundWork owned(nullptr, turn);
      owned.start([&](const Effort& effort) -> Deliver {
        began.set_value();
        while (!effort.isCancelled())
          std::this_thread::yield();
        ++ended;
        return [this] { results.push_back(0); };
      });
      began.get_future().wait();
    }
    EXPECT_EQ(ended.exchange(0), 1);
  }
  QCoreApplication::processEvents();
  EXPECT_TRUE(results.empty());
}

} // namespace
} // namespace limn
