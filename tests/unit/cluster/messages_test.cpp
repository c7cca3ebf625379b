#include "src/studies/cluster/messages.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rubicon::cluster {
namespace {

Answer whole_answer() {
  Answer answer;
  answer.number = 12;
  answer.result.digest = "abc";
  study::VariantFacts& facts = answer.result.facts.emplace();
  facts.tasks = {"set_1", "", "wall"};
  facts.start_at = schedule::CivilTime{{2026, 3, 2}, 450};
  facts.currency = "EUR";
  facts.costed = true;
  auto table = std::make_shared<sampling::MeasuredTimes>();
  table->file = "times.csv";
  table->unit = "min";
  table->column = 3;
  table->times = {60, 90.5, 1e-3};
  table->mean = 50;
  table->least = 1e-3;
  table->most = 90.5;
  facts.uncertain.push_back({"set_1.hook", {sampling::Law::pert, {60, 120, 600}, {}}});
  facts.uncertain.push_back({"set_2.hook", {sampling::Law::measured, {}, table}});
  facts.uncertain.push_back({"set_3.hook", {sampling::Law::measured, {}, table}});
  answer.result.runs.push_back({3, 7, {{1.5, 2, 0}, {0, 2}, {0, 1, 1.5}, {}, ""}});
  return answer;
}

TEST(Messages, AreReadAsTheyWereWritten) {
  const Answer answer = whole_answer();
  const std::string text = write_message(answer);
  const auto read = read_message(text, 3);
  ASSERT_TRUE(read);
  const auto& again = std::get<Answer>(*read);
  EXPECT_EQ(again.result.runs.front().record, answer.result.runs.front().record);
  const study::VariantFacts& facts = *again.result.facts;
  EXPECT_EQ(facts.tasks, answer.result.facts->tasks);
  EXPECT_EQ(facts.start_at, answer.result.facts->start_at);
  EXPECT_EQ(facts.uncertain[0].law.values, answer.result.facts->uncertain[0].law.values);
  EXPECT_EQ(facts.uncertain[1].law.measured, facts.uncertain[2].law.measured) << "one table";
  EXPECT_EQ(facts.uncertain[1].law.measured->times, (std::vector<double>{60, 90.5, 1e-3}));
  EXPECT_EQ(write_message(*read), text);

  const Order order{5, {2, {{"bays", "4"}, {"crane", "a \t\n b"}}, {0, 4, 9}}};
  const auto piece = std::get<Order>(*read_message(write_message(order), 3)).piece;
  EXPECT_EQ(piece.set, order.piece.set);
  EXPECT_EQ(piece.runs, order.piece.runs);
}

TEST(Messages, WhatIsDamagedIsRefusedOrIsAnotherMessage) {
  const std::string text = write_message(whole_answer());
  EXPECT_FALSE(read_message("", 3));
  EXPECT_FALSE(read_message(text, 4)) << "of a study with other questions";
  EXPECT_FALSE(read_message(text + "x", 3));
  for (std::size_t size = 0; size < text.size(); ++size) {
    EXPECT_FALSE(read_message(std::string_view(text).substr(0, size), 3)) << size;
  }
  std::mt19937 random(1);
  for (int i = 0; i < 20'000; ++i) {
    std::string damaged = text;
    damaged[random() % damaged.size()] = static_cast<char>(random());
    // What is read after all can be written: all of it is there.
    const auto read = read_message(damaged, 3);
    EXPECT_TRUE(!read || !write_message(*read).empty());
  }
}

}  // namespace
}  // namespace rubicon::cluster
