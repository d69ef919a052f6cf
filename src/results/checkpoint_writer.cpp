#include "results/checkpoint_writer.h"

#include <utility>

namespace knitmech::results {

CheckpointWriter::CheckpointWriter(std::filesystem::path dir, double interval)
    : dir_(std::move(dir)), interval_(interval) {}

bool CheckpointWriter::is_due() const {
  if (interval_ <= 0 || std::chrono::duration<double>(Clock::now() - last_).count() < interval_) return false;
  return !writing_.valid() || writing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

void CheckpointWriter::write(Checkpoint checkpoint, std::function<void()> first) {
  wait();
  last_ = Clock::now();
  writing_ = std::async(std::launch::async, [dir = dir_, checkpoint = std::move(checkpoint), first = std::move(first)] {
    first();
    write_checkpoint(dir, checkpoint);
  });
}

void CheckpointWriter::wait() {
  if (writing_.valid()) writing_.get();
}

}  // namespace knitmech::results
