// Plays a recording: everything that was sent and received, in its order and at its own pace or another.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include <QObject>
#include <QTimer>

#include "core/base/clock.h"
#include "core/link/recording_parts.h"
#include "core/link/recording_reader.h"
#include "core/protocol/line_splitter.h"

namespace usar::link {

/// Receives what a replay plays. Views are valid during the call.
class ReplayTaker {
public:
    virtual ~ReplayTaker() = default;
    /// Everything received so far is void; it comes again from the beginning.
    virtual void rewound() = 0;
    /// `place` is "host:port".
    virtual void opened(std::string_view place) = 0;
    virtual void closed(std::string_view reason) = 0;
    /// One info line without its line end, and the number that it had.
    virtual void line(std::string_view text, LineNumber number) = 0;
    /// An Out record: a command with its line end, and its cause.
    virtual void sent(const Record& record) = 0;
    virtual void note(const Record& record) = 0;
    /// True: everything up to the next call with false is only passed on the way to another moment.
    virtual void quiet(bool on) = 0;
};

/// Times count from the beginning of the recording, by PlayClock.
struct ReplayFigures {
    Seconds position{0.0};
    Seconds span{0.0};
    double speed = 1.0; ///< multiple of PlayClock's pace; infinity: as fast as possible
    bool playing = false;
    bool seeking = false; ///< on the way to `position`
    bool operator==(const ReplayFigures&) const = default;
};

/// Lines pass through a LineSplitter as on a live link and have the numbers that they had; a command that was sent
/// between two lines of one chunk comes between them again. Works in turns of 20 ms, so that its thread stays
/// responsive; if it cannot keep up, it is late and skips nothing. Runs in its owner's thread, which needs an event
/// loop. It starts paused at the beginning.
class Replayer : public QObject {
    Q_OBJECT
public:
    static constexpr double slowest = 0.1;
    static constexpr double fastest = 100.0;

    /// `taker` must outlive the replayer.
    Replayer(std::unique_ptr<RecordingReader> recording, ReplayTaker& taker);

    const RecordingSurvey& survey() const { return recording_->survey(); }
    ReplayFigures figures() const;

    /// Plays or pauses. Playing at the end starts again from the beginning.
    void setPlaying(bool playing);
    /// Multiple of PlayClock's pace, clamped to 0.1 to 100; infinity for as fast as possible; 1 for anything not above
    /// 0.
    void setSpeed(double speed);
    /// Moves to `position`, clamped to the recording, by playing everything up to it; moving backward starts from the
    /// beginning of the recording. A further call on the way replaces the one before.
    void seek(Seconds position);
    /// Seeks to the moment at which the robot's clock read `now`; does nothing if the recording contains no clock.
    void seekToClock(Seconds now);
    /// Playing ends at `end` instead of at the end of the recording; a seek may go beyond it.
    void setEnd(Seconds end);
    /// Pauses, then plays the next bytes from the server and the records before and between their lines. During a seek
    /// it only pauses.
    void step();

signals:
    /// Emitted when playing or speed changes, when a seek begins or arrives, and at the end.
    void changed();
    void ended();
    /// Damage that the survey did not have until now was met, and passed over.
    void damaged();

private:
    using Clock = std::chrono::steady_clock;
    /// A record that owns its texts, because it waits while others are read.
    struct Waiting {
        Record record;
        RecordTime due{0};
        std::string name;
        std::string bytes;
        Record view() const;
    };

    const Waiting* peek();
    /// Plays the record that `peek` has returned; true if it was a chunk of bytes from the server.
    bool playNext();
    void play(const Record& record);
    void playChunk(const Waiting& chunk);
    /// Plays what was recorded within a chunk before the line of this number.
    void playBefore(LineNumber number);
    /// Plays what is due, for one turn; returns true if more of it is left.
    bool playUntil(RecordTime time);
    void turn();
    void rewind();
    void arrive();
    /// Sets the position, from which counting continues now.
    void settle(RecordTime position);
    RecordTime dueNow() const;
    /// Starts the timer for the next turn, if one is needed.
    void arm();

    std::unique_ptr<RecordingReader> recording_;
    ReplayTaker& taker_;
    QTimer timer_{this};
    protocol::LineSplitter splitter_;
    PlayClock clock_;
    PartSeam seam_;
    std::optional<Waiting> next_;  ///< read from the recording but not played yet
    std::size_t known_damage_ = 0; ///< pieces in the survey when it was looked at last
    LineNumber number_;            ///< newest info line
    RecordTime position_{0};       ///< at the time `since_`
    Clock::time_point since_;
    std::optional<RecordTime> target_; ///< where a seek is going
    RecordTime end_;                   ///< where playing ends
    double speed_ = 1.0;
    bool playing_ = false;
    bool ended_ = false;    ///< it played to the end, and no seek has followed
    bool connected_ = true; ///< a recording without an Opened record counts as open
};

} // namespace usar::link
