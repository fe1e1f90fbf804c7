// The seconds after a mission's end, in which a robot that was stopped should stay out of trouble.
#pragma once

#include <functional>
#include <optional>

#include <QObject>

#include "core/base/clock.h"
#include "core/mission/runs/run_summary.h"
#include "core/mission/session/robot_session.h"

namespace usar::mission {

/// Watches a robot after its behavior has ended and the session has sent the safe command. Only a simulator can tell
/// what it touches. Belongs to the session's thread.
class AfterStop : public QObject {
    Q_OBJECT
public:
    static constexpr Seconds span{5.0}; ///< on the protocol clock; a robot at full speed stands after a second or two

    using AskTruth = std::function<std::optional<TrueFigures>()>;
    /// The session must outlive this object.
    AfterStop(RobotSession& session, AskTruth ask, QObject* parent = nullptr);

    /// Begins to watch; `over` follows. Returns false if there is nothing to watch: a broken robot, none at all, or a
    /// connection that is lost.
    bool begin(const std::optional<TrueFigures>& at_end);
    /// Ends the watch early, without a result.
    void giveUp();
    /// Adds to `at_end` what has happened since then; nothing if the watch was given up. The contacts of a robot
    /// that was without power meanwhile do not count, because nothing could have kept it from them.
    void addTo(TrueFigures& at_end) const;

signals:
    void over(); ///< once

private:
    void end(bool whole);

    RobotSession& session_;
    AskTruth ask_;
    bool watching_ = false;
    std::optional<TrueFigures> after_; ///< nullopt: not watched to the end
};

} // namespace usar::mission
