// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Pieces.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkWireWarpingFilter.h>

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace editor
{
/// How well a piece is laid out.
enum class Care
{
  Draft, ///< by the global scheme, which takes a fraction of the time; wires as long as they are
  Full,
};

/// Ends a run from within, where its progress is reported: no other thread may touch the filter.
class Stopper : public vtkCommand
{
public:
  static Stopper* New() { return new Stopper; }
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    if (this->isOver())
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  }

  std::function<bool()> isOver;
};

/// Flattens one surface again and again, with other curves, on a thread of its own.
///
/// Who asks goes on at once. What is asked while a run is under way waits; what waits is replaced
/// by what is asked later, and ends a run that it would have to wait long for. Data go to the
/// thread and come from it as copies, so that none of VTK's objects is known to two threads. All
/// functions are for one thread, that of the window.
class LiveFlattening
{
public:
  /// \param onDone is called on the other thread when there is something to take()
  explicit LiveFlattening(std::function<void()> onDone = {});
  /// Ends a run that is under way, and waits for its end.
  ~LiveFlattening();
  LiveFlattening(const LiveFlattening&) = delete;
  LiveFlattening& operator=(const LiveFlattening&) = delete;

  /// Forgets all that was asked for and found.
  void setSurface(vtkPolyData* surface);
  /// For what is asked from now on, as vtkWireWarpingFilter has them. \return whether they are
  /// others
  bool setCloth(const std::string& material, const std::vector<std::string>& grain);
  void ask(vtkPolyData* curves, Care care);
  /// Makes what was found last result() and message(). \return whether there was something new
  bool take();
  /// Whether something was asked for that is not taken yet.
  bool isBusy() const;

  bool hasResult() const { return this->Result.flat != nullptr; }
  const figures::FlatPiece& result() const { return this->Result; }
  /// Whether what was taken last was refused, so that result() is of other curves.
  bool isRefused() const { return this->Refused; }
  /// What is refused, or broken unless the result is a draft; empty where all is well.
  const std::string& message() const { return this->Message; }
  /// Of the result.
  Care care() const { return this->ResultCare; }
  /// What the last run with this care took; 0 before the first.
  double seconds(Care care) const { return this->Seconds[static_cast<std::size_t>(care)]; }

private:
  using Clock = std::chrono::steady_clock;

  struct Order
  {
    figures::PolyData surface;
    figures::PolyData curves;
    Care care = Care::Full;
    std::string material;
    std::vector<std::string> grain;
  };
  struct Answer
  {
    std::optional<figures::FlatPiece> piece; ///< none: refused
    std::string message;
    Care care = Care::Full;
    double seconds = 0.0;
  };

  void work();
  std::optional<Answer> flatten(const Order& order);
  /// Whether the run under way is for nothing.
  bool isOvertaken();

  // Of the other thread, once it works.
  vtkNew<vtkWireWarpingFilter> Filter;
  vtkPolyData* Known = nullptr; ///< the surface of the filter
  Clock::time_point Start;
  Care Doing = Care::Full;

  // Of both threads, under the guard.
  mutable std::mutex Guard;
  std::condition_variable Wake; ///< the other thread: there is something to do
  std::optional<Order> Waiting;
  std::optional<Answer> Found;
  bool Running = false;
  bool Useless = false; ///< what runs is of an earlier surface
  bool Ending = false;

  std::function<void()> OnDone;
  figures::PolyData Surface; ///< a copy for the other thread, looked at by no one else
  std::string Material;
  std::vector<std::string> Grain;
  figures::FlatPiece Result;
  std::string Message;
  bool Refused = false;
  std::array<double, 2> Seconds{}; ///< by care
  Care ResultCare = Care::Full;
  std::thread Worker; ///< last, since it uses all of the above
};
}
