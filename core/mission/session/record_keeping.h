// The recording of a session in progress: every byte with its time and cause, and notes of facts that only we know.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <QTimer>

#include "core/link/recording_writer.h"
#include "core/link/tcp_link.h"
#include "core/mission/files/fault_note.h"
#include "core/mission/files/scan_record.h"
#include "core/mission/session/behavior_so_far.h"
#include "core/mission/session/incoming.h"
#include "core/mission/session/notices.h"
#include "core/mission/session/session_orders.h"
#include "core/protocol/command.h"

namespace usar::mission {

/// State of a session when its recording begins, or another part of it.
struct RecordingScene {
    link::LinkStatus link;
    std::string_view pending{};              ///< received part of a line that has not ended
    double cell_size_m = 0.0;                ///< cell size of the height map
    std::string level{};                     ///< name of the server's map; empty: unknown
    std::optional<protocol::Init> robot{};   ///< nullopt: no robot was requested
    const ScanRecord* of_behavior = nullptr; ///< its task and marks; null: no behavior runs
};

/// While nothing is recorded, it only keeps the values with which a recording would have to begin. If writing fails, it
/// reports a notice and ends the recording. With a limit of size, the recording is cut into parts, and the oldest are
/// deleted; a notice says so before it happens, and each time. Belongs to one session and its thread, which waits for
/// the disk only at the end of a recording.
class RecordKeeping {
public:
    /// `owner` belongs to the session's thread; it, `notices` and `incoming` must outlive this object. `scene` is asked
    /// when a recording or a part begins; `looked` is called twice a second during a recording.
    RecordKeeping(QObject& owner, Notices& notices, const Incoming& incoming, std::function<RecordingScene()> scene,
                  std::function<void()> looked);

    /// Ends any current recording and starts a new one with the state that its reader could not know otherwise.
    Result<void> begin(const QString& path, RecordingFacts facts);
    void end();
    /// The limit holds for this recording and later ones; at first there is none. A number below
    /// RecordingParts::least_limit_bytes counts as that. Deletions that an earlier limit has asked for are called off.
    void setLimit(RecordingLimit limit_bytes);
    bool on() const { return writer_ != nullptr; }
    /// Path of the file; empty if nothing is recorded.
    QString path() const { return writer_ ? QString::fromStdString(writer_->path()) : QString(); }
    /// As RecordingWriter::flush; needs a recording.
    void flush(std::function<void()> done) { writer_->flush(std::move(done)); }
    /// Returns nullopt if nothing is recorded.
    std::optional<RecordingFigures> figures() const;

    /// `place` is "host:port".
    void opened(const std::string& place) { put({.kind = link::RecordKind::Opened, .bytes = place}); }
    void closed(const std::string& reason) { put({.kind = link::RecordKind::Closed, .bytes = reason}); }
    void received(std::string_view bytes) { put({.kind = link::RecordKind::In, .bytes = bytes}); }
    void sent(const Cause& cause, const std::string& text);
    /// Notes a fault, or that it has ended. One that still holds is told again by a recording or a part that begins.
    void noteFault(const std::string& sentence);
    void forgetFaults() { faults_ = {}; }
    /// The behavior and the area named in `record` have begun.
    void noteTask(const ScanRecord& record);
    /// The behavior that begins flies the mission of this text (core/mission/files/flown_mission.h). It comes before
    /// its task; an empty text is no note.
    void noteMission(const std::string& text);
    /// Notes a value published by a behavior. With `runs_here`, the newest of values that replace each other is also
    /// kept for a later recording.
    void notePublished(const agent::Published& value, bool runs_here);
    /// Notes the end of a behavior that did not publish it itself.
    void noteFinished(const agent::BehaviorFinished& finished);
    /// Forgets the values of the behavior because it is gone.
    void forgetBehavior() {
        so_far_.clear();
        mission_.clear();
    }
    /// Ends a recording whose writing has failed, with a notice; keeps the limit of one that goes well.
    void look();

private:
    using Clock = std::chrono::steady_clock;
    Seconds elapsed() const { return Clock::now() - began_; }
    void beginWith(const RecordingScene& scene);
    void keepLimit();
    void beginNextPart();
    /// Says once that the limit is near, and what happens there.
    void warn();
    /// Says which parts were deleted since the last call.
    void sayDropped();
    void write(const agent::Published& value);
    void note(std::string_view topic, std::string_view text);
    /// Writes the record, with the number of the newest line, if a recording is on.
    void put(link::Record record);

    Notices& notices_;
    const Incoming& incoming_;
    QTimer timer_; ///< runs during a recording
    std::function<RecordingScene()> scene_;
    std::unique_ptr<link::RecordingWriter> writer_;
    RecordingFacts facts_;    ///< They describe the recording that is on.
    Clock::time_point began_; ///< The recording that is on began then.
    RecordingLimit limit_bytes_;
    bool warned_ = false;      ///< about this recording and this limit
    bool set_late_ = false;    ///< The limit was set in this recording, and was not looked at yet.
    Seconds delete_from_{0.0}; ///< since the recording began
    StandingFaults faults_;
    BehaviorSoFar so_far_; ///< what the running behavior has published
    std::string mission_;  ///< text of the mission that it flies; empty: unknown
};

} // namespace usar::mission
