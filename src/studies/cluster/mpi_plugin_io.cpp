// The file rubicon-mpi.so, which alone knows MPI: see mpi_plugin.hpp.
#include <mpi.h>

#include <chrono>
#include <list>
#include <string>
#include <thread>

#include "src/studies/cluster/mpi_plugin.hpp"

namespace rubicon::cluster {

namespace {

constexpr int kTag = 18;

struct MessageUnderWay {
  std::string bytes;
  MPI_Request request = MPI_REQUEST_NULL;
};

/// Messages on their way. MPI knows one job a process.
std::list<MessageUnderWay>& sendings() {
  static std::list<MessageUnderWay> list;
  return list;
}

void let_go_of_sent() {
  sendings().remove_if([](MessageUnderWay& each) {
    int sent = 0;
    return MPI_Test(&each.request, &sent, MPI_STATUS_IGNORE) != MPI_SUCCESS || sent != 0;
  });
}

int mpi_rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int mpi_size() {
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  return size;
}

void mpi_send(int to, const char* bytes, long size) {
  let_go_of_sent();
  MessageUnderWay& each = sendings().emplace_back();
  each.bytes.assign(bytes, static_cast<std::size_t>(size));
  MPI_Isend(each.bytes.data(), static_cast<int>(size), MPI_BYTE, to, kTag, MPI_COMM_WORLD,
            &each.request);
}

long mpi_look(int* from) {
  let_go_of_sent();
  int is_there = 0;
  MPI_Status status;
  if (MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &is_there, &status) != MPI_SUCCESS ||
      is_there == 0) {
    return -1;
  }
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  *from = status.MPI_SOURCE;
  return size;
}

/// A long message is fetched from its sender, who may be lost by then: MPI would wait for ever.
int mpi_take(int from, char* bytes, long size) {
  using namespace std::chrono_literals;
  constexpr auto kLongest = 20s;
  static std::list<MessageUnderWay> given_up;  // MPI may still write there
  std::list<MessageUnderWay> own(1);
  MessageUnderWay& each = own.front();
  each.bytes.resize(static_cast<std::size_t>(size));
  if (MPI_Irecv(each.bytes.data(), static_cast<int>(size), MPI_BYTE, from, kTag, MPI_COMM_WORLD,
                &each.request) != MPI_SUCCESS) {
    return 0;
  }
  const auto begin = std::chrono::steady_clock::now();
  int is_there = 0;
  while (MPI_Test(&each.request, &is_there, MPI_STATUS_IGNORE) == MPI_SUCCESS && is_there == 0) {
    if (std::chrono::steady_clock::now() - begin > kLongest) {
      given_up.splice(given_up.end(), own);
      return 0;
    }
    std::this_thread::sleep_for(50us);
  }
  each.bytes.copy(bytes, each.bytes.size());
  return is_there;
}

void mpi_end(int all_there) {
  using namespace std::chrono_literals;
  const int longest = all_there != 0 ? 10'000 : 200;  // ms; who is lost takes nothing any more
  for (int i = 0; i < longest && !sendings().empty(); ++i) {
    std::this_thread::sleep_for(1ms);
    let_go_of_sent();
  }
  // Without all ranks it would wait for ever.
  if (all_there != 0) MPI_Finalize();
}

}  // namespace

extern "C" const MpiPlugin* rubicon_mpi_begin(int version) {
  static const MpiPlugin plugin = {mpi_rank, mpi_size, mpi_send, mpi_look, mpi_take, mpi_end};
  int provided = 0;
  if (version != kMpiPluginVersion ||
      MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS ||
      provided < MPI_THREAD_FUNNELED) {
    return nullptr;
  }
  // A rank that is lost is found by its silence, and its work is done by others.
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
  return &plugin;
}

}  // namespace rubicon::cluster
