// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/mpi/Ranks.h"

#include <new>

namespace limn {
namespace {

static_assert(sizeof(ScalarShare) == 2 * sizeof(double));

// What MPI counts with an int: strips of pictures, and what is found of a part, are far smaller.
int asCount(std::size_t size) {
  return static_cast<int>(size);
}

constexpr int joiningTag = 1;

void send(const std::string& text, int to) {
  MPI_Send(text.data(), asCount(text.size()), MPI_CHAR, to, joiningTag, MPI_COMM_WORLD);
}

std::string received(int from) {
  MPI_Status status;
  int size = 0;
  MPI_Probe(from, joiningTag, MPI_COMM_WORLD, &status);
  MPI_Get_count(&status, MPI_CHAR, &size);
  std::string text(static_cast<std::size_t>(size), '\0');
  MPI_Recv(text.data(), size, MPI_CHAR, from, joiningTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return text;
}

} // namespace

Ranks::Ranks(int& argc, char**& argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &m_rank);
  MPI_Comm_size(MPI_COMM_WORLD, &m_count);
}

Ranks::~Ranks() {
  MPI_Finalize();
}

int Ranks::onThisMachine() const {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int count = 1;
  MPI_Comm_size(machine, &count);
  MPI_Comm_free(&machine);
  return count;
}

std::string Ranks::fromFirst(const std::string& text) const {
  std::string received = text;
  int size = asCount(received.size());
  MPI_Bcast(&size, 1, MPI_INT, 0, MPI_COMM_WORLD);
  received.resize(static_cast<std::size_t>(size));
  MPI_Bcast(received.data(), size, MPI_CHAR, 0, MPI_COMM_WORLD);
  return received;
}

void Ranks::agree(const std::optional<Error>& failure) const {
  const int mine = failure ? m_rank : m_count;
  int failed = m_count;
  MPI_Allreduce(&mine, &failed, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (failed == m_count)
    return;
  std::string sentence = failed == m_rank ? failure->what() : "";
  int said[2] = {asCount(sentence.size()), failed == m_rank ? static_cast<int>(failure->kind()) : 0};
  MPI_Bcast(said, 2, MPI_INT, failed, MPI_COMM_WORLD);
  sentence.resize(static_cast<std::size_t>(said[0]));
  MPI_Bcast(sentence.data(), said[0], MPI_CHAR, failed, MPI_COMM_WORLD);
  throw Error(static_cast<Error::Kind>(said[1]), Message(sentence));
}

void Ranks::smallest(std::vector<float>& values) const {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), asCount(values.size()), MPI_FLOAT, MPI_MIN, MPI_COMM_WORLD);
}

std::string Ranks::joined(std::string text,
                          const std::function<std::string(std::string, std::string)>& join) const {
  // Neighbours join, then neighbouring pairs, and so on, so that the order of the ranks is kept.
  for (int step = 1; step < m_count; step *= 2) {
    if (m_rank % (2 * step) != 0) {
      send(text, m_rank - step);
      break;
    }
    if (m_rank + step < m_count)
      text = join(std::move(text), received(m_rank + step));
  }
  return fromFirst(text);
}

std::vector<ScalarShare> Ranks::folded(const std::vector<ScalarShare>& shares, Folding folding) const {
  std::vector<ScalarShare> result(isFirst() ? shares.size() : 0);
  MPI_Reduce(shares.data(), result.data(), asCount(2 * shares.size()), MPI_DOUBLE,
             folding == Folding::sum ? MPI_SUM : MPI_MAX, 0, MPI_COMM_WORLD);
  return result;
}

std::vector<double> Ranks::gathered(const std::vector<double>& numbers) const {
  std::vector<double> all(isFirst() ? numbers.size() * static_cast<std::size_t>(m_count) : 0);
  MPI_Gather(numbers.data(), asCount(numbers.size()), MPI_DOUBLE, all.data(), asCount(numbers.size()),
             MPI_DOUBLE, 0, MPI_COMM_WORLD);
  return all;
}

std::optional<Error> failureOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return Error(Error::Kind::other, "There is not enough memory on a rank for its part of the picture; use "
                                     "more machines, fewer ranks on each, or a smaller picture.");
  } catch (const std::exception& error) {
    return Error(Error::Kind::other, Message(std::string("Something unexpected failed on a rank: ") +
                                             error.what() + ". Please report it with `limn info --system`."));
  }
  return std::nullopt;
}

} // namespace limn
