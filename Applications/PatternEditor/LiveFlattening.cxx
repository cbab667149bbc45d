// SPDX-License-Identifier: BSD-3-Clause
#include "LiveFlattening.h"

#include "Files.h"
#include "WindowWords.h"

#include <new>
#include <utility>

namespace editor
{
namespace
{
/// How long a newer order waits for a run. A draft is worth its wait: orders may come faster than
/// it can be made, and then none would ever be seen.
constexpr std::chrono::milliseconds patience(Care care)
{
  return std::chrono::milliseconds(care == Care::Draft ? 300 : 40);
}

/// Above so many triangles the inside of a draft is that of the paper's linear system, as the
/// rigid one would take as long as no draft. Of 22,600 triangles: 0.13 s in place of 3.7 s.
constexpr vtkIdType mostRigidTriangles = 5000;

template <class Data>
vtkSmartPointer<Data> copyOf(Data* data)
{
  auto copy = vtkSmartPointer<Data>::New();
  copy->DeepCopy(data);
  return copy;
}
}

LiveFlattening::LiveFlattening(std::function<void()> onDone)
  : OnDone(std::move(onDone))
{
  figures::silence(this->Filter); // what it says is shown in the window, by its status
  this->Filter->CachingOn();
  this->Filter->ReleaseTrialsOff(); // the window shows no advice
  vtkNew<Stopper> stopper;
  stopper->isOver = [this] { return this->isOvertaken(); };
  this->Filter->AddObserver(vtkCommand::ProgressEvent, stopper);
  this->Worker = std::thread([this] { this->work(); });
}

LiveFlattening::~LiveFlattening()
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Ending = true;
  }
  this->Wake.notify_one();
  this->Worker.join();
}

void LiveFlattening::setSurface(vtkPolyData* surface)
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Waiting.reset();
    this->Found.reset();
    this->Useless = this->Running;
  }
  this->Surface = copyOf(surface);
  this->Result = {};
  this->Message.clear();
  this->Refused = false;
  this->Seconds = {};
}

bool LiveFlattening::setCloth(const std::string& material, const std::vector<std::string>& grain)
{
  const bool others = material != this->Material || grain != this->Grain;
  this->Material = material;
  this->Grain = grain;
  return others;
}

void LiveFlattening::ask(vtkPolyData* curves, Care care)
{
  Order order{ this->Surface, copyOf(curves), care, this->Material, this->Grain };
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Waiting = std::move(order);
  }
  this->Wake.notify_one();
}

bool LiveFlattening::take()
{
  std::optional<Answer> answer;
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    answer = std::exchange(this->Found, std::nullopt);
  }
  if (!answer)
  {
    return false;
  }
  this->Message = std::move(answer->message);
  this->Refused = !answer->piece;
  this->Seconds[static_cast<std::size_t>(answer->care)] = answer->seconds;
  if (answer->piece)
  {
    this->Result = *std::move(answer->piece);
    this->ResultCare = answer->care;
  }
  return true;
}

bool LiveFlattening::isBusy() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Waiting || this->Found || (this->Running && !this->Useless);
}

bool LiveFlattening::isOvertaken()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Ending || this->Useless ||
    (this->Waiting && Clock::now() - this->Start > patience(this->Doing));
}

void LiveFlattening::work()
{
  std::unique_lock<std::mutex> lock(this->Guard);
  for (;;)
  {
    this->Wake.wait(lock, [this] { return this->Ending || this->Waiting; });
    if (this->Ending)
    {
      return;
    }
    const Order order = *std::exchange(this->Waiting, std::nullopt);
    this->Running = true;
    this->Useless = false;
    lock.unlock();
    std::optional<Answer> answer;
    try
    {
      answer = this->flatten(order);
    }
    catch (const std::bad_alloc&)
    {
      answer = Answer{ {}, "there is not enough memory to flatten the surface", order.care, 0.0 };
    }
    lock.lock();
    this->Running = false;
    const bool useful = answer && !this->Useless;
    if (useful)
    {
      this->Found = std::move(answer);
    }
    if (useful && this->OnDone)
    {
      lock.unlock();
      this->OnDone();
      lock.lock();
    }
  }
}

std::optional<LiveFlattening::Answer> LiveFlattening::flatten(const Order& order)
{
  if (this->Known != order.surface)
  {
    this->Filter->SetInputData(order.surface);
    this->Known = order.surface;
  }
  const bool draft = order.care == Care::Draft;
  draft ? this->Filter->SetSchemeToGlobal() : this->Filter->SetSchemeToIsometric();
  const bool plainly = draft && order.surface->GetNumberOfCells() > mostRigidTriangles;
  plainly ? this->Filter->SetInteriorToLaplacian() : this->Filter->SetInteriorToAsRigidAsPossible();
  this->Filter->SetMaterial(order.material.c_str());
  this->Filter->RemoveAllGrains();
  for (const std::string& grain : order.grain)
  {
    this->Filter->AddGrain(grain);
  }
  this->Filter->SetAbortExecute(0); // newer versions of VTK keep it
  this->Doing = order.care;
  this->Start = Clock::now();
  this->Filter->SetCurvesData(order.curves);
  this->Filter->Update();
  const std::chrono::duration<double> passed = Clock::now() - this->Start;
  if (this->Filter->GetStatusCode() == vtkFlatteningAlgorithm::CANCELLED)
  {
    return std::nullopt;
  }
  Answer answer;
  answer.care = order.care;
  answer.seconds = passed.count();
  const bool refused = this->Filter->IsRefused();
  // What is broken in a draft need not be in the piece.
  answer.message = draft && !refused ? "" : messageOf(this->Filter);
  if (!refused)
  {
    answer.piece = { copyOf(this->Filter->GetOutput(0)), copyOf(this->Filter->GetOutput(1)),
      copyOf(this->Filter->GetOutput(2)), copyOf(this->Filter->GetPieces()),
      copyOf(this->Filter->GetCurves()) };
  }
  return answer;
}
}
