// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Memory.h"

#include "Base/LargeArray.h"

#include <memory>
#include <string>

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) // it watches what operator new gives
#define FLATTENING_LARGE_PAGES
#include <sys/mman.h>
#endif

namespace flattening
{
#ifdef FLATTENING_LARGE_PAGES
namespace
{
/// What is mapped for them: large pages, and small ones for a rest that is not worth one.
std::size_t mappedBytes(std::size_t bytes)
{
  constexpr std::size_t smallPage = std::size_t(1) << 16; // or some of them
  const std::size_t page = bytes % largePage < worthLargePages ? smallPage : largePage;
  return (bytes + page - 1) / page * page;
}

/// Begins where a large page does.
void* mapLarge(std::size_t bytes)
{
  const std::size_t used = mappedBytes(bytes);
  std::size_t room = used + largePage;
  void* const mapped =
    mmap(nullptr, room, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room < bytes || mapped == MAP_FAILED)
  {
    throw std::bad_alloc();
  }
  void* memory = mapped;
  std::align(largePage, used, memory, room);
  const std::size_t before = used + largePage - room;
  if (before > 0)
  {
    munmap(mapped, before);
  }
  if (room > used)
  {
    munmap(static_cast<char*>(memory) + used, room - used);
  }
  madvise(memory, used, MADV_HUGEPAGE); // where it is refused, pages stay small
  return memory;
}
}
#endif

void* allocateLarge(std::size_t bytes)
{
#ifdef FLATTENING_LARGE_PAGES
  if (bytes >= worthLargePages)
  {
    return mapLarge(bytes);
  }
#endif
  return ::operator new(bytes);
}

void releaseLarge(void* memory, [[maybe_unused]] std::size_t bytes) noexcept
{
#ifdef FLATTENING_LARGE_PAGES
  if (bytes >= worthLargePages)
  {
    munmap(memory, mappedBytes(bytes));
    return;
  }
#endif
  ::operator delete(memory);
}

void throwOutOfMemory(std::size_t bytes)
{
  throw OutOfMemory(bytes);
}

Status outOfMemory(std::size_t bytes)
{
  const double gigabytes = 1e-9 * static_cast<double>(bytes);
  return { StatusCode::OutOfMemory,
    "memory ran out" +
      (bytes > 0 ? " (one factorization wants " + shortNumber(gigabytes) + " GB)" : std::string()),
    {}, { Remedy::FreeMemory } };
}

Status outOfThreads(const std::string& reason)
{
  return { StatusCode::OutOfMemory,
    "memory ran out, or the limit of threads was met (" + reason + ")", {},
    { { Remedy::Give, "a higher limit of processes (ulimit -u)" }, Remedy::FreeMemory } };
}
}
