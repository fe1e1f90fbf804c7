#include "core/mission/runs/recorded_plan.h"

#include <utility>

#include "core/base/byte_codec.h"

namespace usar::mission {

using posh::trace_codec::Frame;

namespace {

/// Between two keys lie 256 cycles, some tens of kB; more than this is no trace of ours.
constexpr std::size_t most_bytes = std::size_t(64) << 20;

std::vector<std::string> innermostRunning(const posh::RunActivity& activity) {
    const posh::Program& program = *activity.program();
    std::vector<bool> has_running_part(program.places.size());
    for (posh::Index place = 0; place < program.places.size(); ++place)
        if (const posh::Index above = program.places[place].parent;
            activity.places()[place].running && above != posh::nowhere)
            has_running_part[above] = true;
    std::vector<std::string> paths;
    for (posh::Index place = 0; place < program.places.size(); ++place)
        if (activity.places()[place].running && !has_running_part[place])
            paths.push_back(posh::namePathOf(program, place));
    return paths;
}

} // namespace

std::optional<std::pair<Frame, std::size_t>> RecordedPlan::frameAt(std::size_t offset) const {
    ByteReader head(std::string_view(bytes_).substr(offset));
    const std::uint64_t length = head.varint();
    const std::size_t content = offset + head.used();
    if (head.failed() || length == 0 || length > posh::trace_codec::longest_frame || length > bytes_.size() - content)
        return std::nullopt;
    return std::pair(static_cast<Frame>(bytes_[content]), content + static_cast<std::size_t>(length));
}

std::size_t RecordedPlan::lastKey() const {
    std::size_t key = 0;
    std::size_t offset = taken_;
    while (const auto frame = frameAt(offset)) {
        if (frame->first == Frame::Key)
            key = offset;
        offset = frame->second;
    }
    return key;
}

void RecordedPlan::begin(std::string bytes) {
    cursor_.reset();
    bytes_ = std::move(bytes);
    taken_ = posh::trace_codec::magic.size();
    auto file = posh::TraceFile::open(std::string_view(bytes_).substr(0, taken_));
    file_ = *std::move(file); // It begins with the magic.
    cursor_ = file_->begin();
}

void RecordedPlan::take(std::string_view piece) {
    if (piece.starts_with(posh::trace_codec::magic))
        begin(std::string(piece));
    else if (file_)
        bytes_ += piece;
    else
        return;
    std::size_t cut = lastKey(); // To cut at each key would copy what follows it as often.
    while (const auto frame = frameAt(taken_)) {
        const auto& [kind, end] = *frame;
        if (kind == Frame::Plan)
            plan_frame_ = bytes_.substr(taken_, end - taken_);
        const std::size_t behind_plan = posh::trace_codec::magic.size() + plan_frame_.size();
        if (taken_ == cut && taken_ > behind_plan) {
            begin(std::string(posh::trace_codec::magic) + plan_frame_ + bytes_.substr(taken_));
            cut = 0;
        } else {
            readTo(end);
        }
    }
    if (bytes_.size() > most_bytes) {
        cursor_.reset();
        file_.reset();
        bytes_.clear();
    }
}

void RecordedPlan::readTo(std::size_t end) {
    taken_ = end;
    file_->extend(std::string_view(bytes_).substr(0, end));
    while (const posh::TracedCycle* const cycle = cursor_->next())
        read(*cycle);
}

void RecordedPlan::read(const posh::TracedCycle& cycle) {
    if (!cycle.program)
        return;
    const auto& known = activity_.program();
    if (known && known != cycle.program && posh::sameShape(*known, *cycle.program))
        activity_.retune(cycle.program);
    else if (known != cycle.program)
        activity_.start(cycle.program);
    for (const posh::trace_codec::Entry& entry : cycle.events)
        activity_.take(entry.record, cycle.textOf(entry));
    ActiveParts parts{cycle.program->title, cycle.number, innermostRunning(activity_)};
    if (parts.plan == told_.plan && parts.paths == told_.paths)
        return;
    told_ = std::move(parts);
    tell_(told_);
}

} // namespace usar::mission
