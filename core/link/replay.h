// Plays a recording: what was said, in its order and at its pace or another.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QObject>
#include <QTimer>

#include "core/base/clock.h"
#include "core/link/play_clock.h"
#include "core/link/recording_reader.h"
#include "core/protocol/line_splitter.h"

namespace usar::link {

/// Who hears what a replay says. Views live during the call.
class ReplayTaker {
public:
    virtual ~ReplayTaker() = default;
    /// All that was heard is void; it comes again from the beginning.
    virtual void rewound() = 0;
    virtual void opened(std::string_view place) = 0;
    virtual void closed(std::string_view reason) = 0;
    virtual void line(std::string_view text, LineNumber number) = 0;
    /// Out: a command with its line end, and its cause.
    virtual void sent(const Record& record) = 0;
    virtual void note(const Record& record) = 0;
    /// What comes until the next call with false is only the way to another moment.
    virtual void quiet(bool on) = 0;
};

/// Times count from the beginning of the recording, by PlayClock.
struct ReplayFigures {
    Seconds position{0.0};
    Seconds span{0.0};
    double speed = 1.0;
    bool playing = false;
    bool seeking = false; ///< on the way to `position`
    bool operator==(const ReplayFigures&) const = default;
};

/// Lines come through a LineSplitter as on a live link and with the numbers that they had; a command that was sent
/// between two lines of one chunk comes between them again. Works in turns of 20 ms, so that its thread stays
/// answerable; where it cannot keep up it is late and skips nothing. Lives in its owner's thread, which has an event
/// loop; paused and at the beginning until told to play.
class Replayer : public QObject {
    Q_OBJECT
public:
    static constexpr double slowest = 0.1;
    static constexpr double fastest = 100.0;

    Replayer(std::unique_ptr<RecordingReader> recording, ReplayTaker& taker, QObject* parent = nullptr);

    const RecordingSurvey& survey() const { return recording_->survey(); }
    ReplayFigures figures() const;

    void setPlaying(bool playing);
    /// Times the pace of PlayClock, 0.1 to 100; infinity for as fast as it can.
    void setSpeed(double speed);
    /// Backward means from the beginning on. A further wish on the way replaces the one before.
    void seek(Seconds position);
    /// To when the robot's clock said so; nothing where the recording knows no clock.
    void seekToClock(Seconds now);
    /// Playing ends there instead of at the end of the recording; a seek may go beyond.
    void setEnd(Seconds end);
    /// Pauses, and goes to the next bytes from the server and whatever they caused.
    void step();

signals:
    /// Playing, speed, a seek that has arrived, or the end.
    void changed();
    void ended();

private:
    using Clock = std::chrono::steady_clock;
    /// A record whose texts are its own, for it waits while others are read.
    struct Waiting {
        Record record;
        RecordTime due{0};
        std::string name;
        std::string bytes;
        Record view() const;
    };

    const Waiting* peek();
    void play(const Record& record);
    void playChunk(const Waiting& chunk);
    /// What happened in the midst of a chunk before the line of this number.
    void playBefore(LineNumber number);
    /// Plays what is due, for one turn; true where there is more of it.
    bool playUntil(RecordTime time);
    void turn();
    void rewind();
    void arrive();
    /// Counting goes on from here.
    void settle(RecordTime position);
    RecordTime dueNow() const;
    void arm();

    std::unique_ptr<RecordingReader> recording_;
    ReplayTaker& taker_;
    QTimer timer_;
    protocol::LineSplitter splitter_;
    PlayClock clock_;
    std::optional<Waiting> next_;
    std::string chunk_;
    LineNumber number_;
    RecordTime position_{0}; ///< where `since_` was set
    Clock::time_point since_;
    std::optional<RecordTime> target_;
    RecordTime end_;
    double speed_ = 1.0;
    bool playing_ = false;
    bool ended_ = false;    ///< nothing has been asked since
    bool connected_ = true; ///< a recording that does not say when it was opened is open
};

} // namespace usar::link
