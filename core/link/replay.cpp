#include "core/link/replay.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace usar::link {

namespace {

constexpr std::chrono::milliseconds turn_length{20};
constexpr std::chrono::milliseconds longest_wait{50}; ///< keeps the displayed position moving

RecordTime toRecordTime(Seconds span) {
    return std::chrono::round<RecordTime>(span); // If truncated, the end of a recording could not be reached.
}

/// The moment of a recording that is nearest to `position`, which may be any number: one that is too large for a
/// RecordTime must not be converted.
RecordTime momentNearest(Seconds position, RecordTime span) {
    if (!(position > Seconds{0.0})) // Also true for NaN.
        return RecordTime{0};
    return position < Seconds(span) ? std::min(toRecordTime(position), span) : span;
}

} // namespace

Record Replayer::Waiting::view() const {
    Record copy = record;
    copy.name = name;
    copy.bytes = bytes;
    return copy;
}

Replayer::Replayer(std::unique_ptr<RecordingReader> recording, ReplayTaker& taker)
    : recording_(std::move(recording))
    , taker_(taker)
    , known_damage_(recording_->survey().damage.size())
    , end_(recording_->survey().play_span) {
    timer_.setSingleShot(true);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &Replayer::turn);
}

ReplayFigures Replayer::figures() const {
    const RecordTime position = target_ ? *target_ : std::min(dueNow(), survey().play_span);
    return {
        .position = position, .span = survey().play_span, .speed = speed_, .playing = playing_, .seeking = !!target_};
}

RecordTime Replayer::dueNow() const {
    if (!playing_ || target_ || std::isinf(speed_))
        return position_;
    return position_ + toRecordTime(speed_ * Seconds(Clock::now() - since_));
}

void Replayer::settle(RecordTime position) {
    position_ = position;
    since_ = Clock::now();
}

void Replayer::setPlaying(bool playing) {
    if (playing == playing_)
        return;
    if (playing && ended_)
        seek(Seconds{0.0}); // Plays once more, as every player does.
    settle(dueNow());
    playing_ = playing;
    arm();
    emit changed();
}

void Replayer::setSpeed(double speed) {
    settle(dueNow());
    speed_ = std::isinf(speed) || !(speed > 0.0) ? speed : std::clamp(speed, slowest, fastest);
    if (!(speed_ > 0.0))
        speed_ = 1.0;
    arm();
    emit changed();
}

void Replayer::seek(Seconds position) {
    const RecordTime wanted = momentNearest(position, survey().play_span);
    settle(dueNow());
    ended_ = false;
    taker_.quiet(true);
    if (wanted < position_)
        rewind();
    target_ = wanted;
    arm();
    emit changed();
}

void Replayer::seekToClock(Seconds now) {
    if (const auto position = survey().clock.at(now))
        seek(*position);
}

void Replayer::setEnd(Seconds end) {
    end_ = momentNearest(end, survey().play_span);
    arm();
}

void Replayer::rewind() {
    recording_->seek(RecordTime{0});
    splitter_.reset();
    next_.reset();
    clock_ = {};
    seam_ = {};
    number_ = {};
    connected_ = true;
    settle(RecordTime{0});
    taker_.rewound();
}

void Replayer::step() {
    setPlaying(false);
    if (target_)
        return;
    while (const Waiting* next = peek()) {
        settle(next->due);
        if (playNext())
            break;
    }
    emit changed();
}

const Replayer::Waiting* Replayer::peek() {
    if (!next_) {
        const auto record = recording_->next();
        if (survey().damage.size() != std::exchange(known_damage_, survey().damage.size()))
            emit damaged();
        if (!record)
            return nullptr;
        next_ = Waiting{*record, clock_.at(*record), std::string(record->name), std::string(record->bytes)};
    }
    return &*next_;
}

bool Replayer::playNext() {
    const Waiting taken = *std::exchange(next_, std::nullopt);
    if (seam_.repeats(taken.view()))
        return false;
    const bool is_chunk = taken.record.kind == RecordKind::In;
    if (is_chunk)
        playChunk(taken);
    else
        play(taken.view());
    return is_chunk;
}

void Replayer::play(const Record& record) {
    switch (record.kind) {
    case RecordKind::Opened:
        splitter_.reset();
        connected_ = true;
        return taker_.opened(record.bytes);
    case RecordKind::Closed:
        connected_ = false;
        return taker_.closed(record.bytes);
    case RecordKind::Out:
        return taker_.sent(record);
    case RecordKind::Note:
        return taker_.note(record);
    default:
        return; // The facts are in the survey.
    }
}

void Replayer::playChunk(const Waiting& chunk) {
    number_ = chunk.record.line;
    splitter_.feed(chunk.bytes, [this](std::string_view text) {
        ++number_.value;
        playBefore(number_);
        if (connected_) // After closing in the middle of a chunk, the rest of it was not read.
            taker_.line(text, number_);
    });
}

void Replayer::playBefore(LineNumber number) {
    while (const Waiting* next = peek()) {
        const RecordKind kind = next->record.kind;
        const bool within = kind == RecordKind::Out || kind == RecordKind::Note || kind == RecordKind::Closed;
        if (!within || next->record.line >= number)
            return;
        playNext();
    }
}

bool Replayer::playUntil(RecordTime time) {
    const auto end = Clock::now() + turn_length;
    while (const Waiting* next = peek()) {
        if (next->due > time)
            return false;
        const RecordTime reached = next->due;
        playNext();
        if (target_ || std::isinf(speed_))
            position_ = reached;
        if (Clock::now() > end) {
            settle(reached); // A delay is not caught up later.
            return true;
        }
    }
    return false;
}

void Replayer::turn() {
    const RecordTime due = std::isinf(speed_) ? end_ : std::min(dueNow(), end_);
    if (playUntil(target_ ? *target_ : due))
        return timer_.start(0);
    if (target_) {
        arrive();
    } else if (playing_ && due == end_) {
        settle(end_);
        playing_ = false;
        ended_ = true;
        emit changed();
        emit ended();
    }
    arm();
}

void Replayer::arrive() {
    settle(*std::exchange(target_, std::nullopt));
    taker_.quiet(false);
    emit changed();
}

void Replayer::arm() {
    timer_.stop();
    if (target_ || (playing_ && std::isinf(speed_)))
        return timer_.start(0);
    if (!playing_)
        return;
    const Waiting* next = peek();
    const RecordTime wait_for = std::min(next ? next->due : end_, end_) - dueNow();
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(Seconds(wait_for) / speed_);
    timer_.start(std::clamp(wait, std::chrono::milliseconds{0}, longest_wait));
}

} // namespace usar::link
