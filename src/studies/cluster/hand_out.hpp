#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "src/studies/cluster/channel.hpp"
#include "src/studies/cluster/messages.hpp"
#include "src/studies/study/work.hpp"

namespace rubicon::cluster {

/// s: a rank from which nothing was heard for so long is lost. It reports every second, whatever
/// it works on.
inline constexpr double kLostAfter = 60;
inline constexpr double kReportEvery = 1;
/// s: rank 0, which may be busy with a search or with answers, is lost after this.
inline constexpr double kRankZeroLostAfter = 600;
/// Pieces that a thread of a rank has at a time: one is under way while the other is on its way.
inline constexpr int kPiecesAThread = 2;

/// Rank 0 of a job: hands the work of a study out to the other ranks, as they ask for it. What a
/// rank had that is lost is done by others. Every rank has as many threads.
class HandOut : public study::RemoteWorkers {
 public:
  /// `digest`: of the study and the program, which a rank must have, too; `on_note` is told when a
  /// rank cannot work or is lost.
  HandOut(Channel& channel, int threads, std::size_t questions, std::string digest,
          std::function<void(const std::string&)> on_note);

  int places() const override;
  bool serve(study::Work& work) override;
  /// Tells all ranks that the study is over.
  void end();
  /// Whether all ranks are still there, also those that are left out.
  bool all_there() const;

 private:
  struct Rank {
    bool is_ready = false;
    bool is_out = false;   ///< it is given nothing any more
    bool is_gone = false;  ///< because it has ended, or is silent
    double heard = 0;
    std::string identity;
    std::map<std::uint64_t, study::Piece> pieces;  ///< of the work that is served now
    int others = 0;                                ///< pieces of work that is over
  };

  bool hear(study::Work& work);
  void take_answer(int number, const Answer& answer, study::Work& work);
  void leave_out(int number, const std::string& why, study::Work& work);
  void look_for_lost(study::Work& work);
  bool hand_pieces(study::Work& work);

  Channel& channel_;
  int threads_;
  std::size_t questions_;
  std::string digest_;
  std::function<void(const std::string&)> on_note_;
  std::vector<Rank> ranks_;  ///< 0 is this one
  std::uint64_t next_ = 0;
  double looked_ = 0;
};

/// What a rank that is not 0 needs.
struct HelperOptions {
  int threads = 1;
  std::string digest;   ///< see HandOut
  std::string failure;  ///< why it cannot work: then it only says so
  study::VariantReader read;
};

/// A rank that is not 0: works on what rank 0 hands out until it says that the study is over, or is
/// gone. Returns whether all other ranks are still there. `study` is not looked at where there is a
/// failure.
bool help(Channel& channel, const study::StudyModel& study, const HelperOptions& options);

}  // namespace rubicon::cluster
