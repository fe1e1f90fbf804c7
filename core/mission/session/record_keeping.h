// The recording of a session while it runs: every byte with its time and cause, and notes of what only we know.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <QTimer>

#include "core/link/recording_writer.h"
#include "core/link/tcp_link.h"
#include "core/mission/files/scan_record.h"
#include "core/mission/session/behavior_so_far.h"
#include "core/mission/session/incoming.h"
#include "core/mission/session/notices.h"
#include "core/mission/session/session_orders.h"
#include "core/protocol/command.h"

namespace usar::mission {

/// Returns "host:port".
std::string placeOf(const link::LinkStatus& status);

/// How things stand in a session when a recording of it begins.
struct RecordingScene {
    link::LinkStatus link;
    std::string_view pending{};              ///< received part of a line that has not ended
    double cell_size_m = 0.0;                ///< of the height map
    std::string level{};                     ///< of the server's map; empty: unknown
    std::optional<protocol::Init> robot{};   ///< absent: none was asked for
    const ScanRecord* of_behavior = nullptr; ///< its task and marks; null: none runs
};

/// Does nothing while nothing is recorded, except that it keeps what a recording would have to begin with. A recording
/// that breaks off is a notice, and ends. Belongs to one session and its thread.
class RecordKeeping {
public:
    /// `owner` lives in the session's thread; it, `notices` and `incoming` must outlive this object. `looked` is called
    /// twice a second during a recording.
    RecordKeeping(QObject& owner, Notices& notices, const Incoming& incoming, std::function<void()> looked);

    /// Ends a recording that runs, and begins with what its reader could not know otherwise.
    Result<void> begin(const QString& path, RecordingFacts facts, const RecordingScene& scene);
    void end();
    bool on() const { return writer_ != nullptr; }
    /// Path of the file; empty if nothing is recorded.
    QString path() const;
    /// As RecordingWriter::flush; needs a recording.
    void flush(std::function<void()> done) { writer_->flush(std::move(done)); }
    /// Absent: nothing is recorded.
    std::optional<RecordingFigures> figures() const;

    /// `place` is "host:port".
    void opened(const std::string& place);
    void closed(const std::string& reason);
    void received(std::string_view bytes);
    void sent(const Cause& cause, const std::string& text);
    void noteFault(const std::string& sentence) { note("fault", sentence); }
    /// The behavior and the area named in `record` have begun.
    void noteTask(const ScanRecord& record);
    /// A value of a behavior. If it runs in this session, what replaces its predecessor is kept for a later recording.
    void notePublished(const agent::Published& value, bool runs_here);
    /// Notes the end of a behavior that did not tell it itself.
    void noteFinished(const agent::BehaviorFinished& finished);
    /// There is no behavior any more, so nothing of it is kept.
    void forgetBehavior() { so_far_.clear(); }
    /// Ends a recording that has broken off, with a notice.
    void look();

private:
    void beginWith(const RecordingScene& scene);
    void write(const agent::Published& value);
    void note(const char* topic, std::string_view text);

    Notices& notices_;
    const Incoming& incoming_;
    QTimer timer_; ///< runs during a recording
    std::unique_ptr<link::RecordingWriter> writer_;
    BehaviorSoFar so_far_; ///< what the running behavior has published
};

} // namespace usar::mission
