// Runs one mission without a window: the same session code, a progress callback, a summary.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QJsonObject>
#include <QObject>

#include "core/agent/plugin_loader.h"
#include "core/mission/mission_file.h"
#include "core/mission/mission_score.h"
#include "core/mission/robot_session.h"

namespace usar::mission {

struct RunOptions {
    QString host = "127.0.0.1";
    quint16 port = 3000;
    bool lockstep = true; ///< ask for it; a real server does not answer
    std::uint64_t seed = 1;
    QString result_folder;  ///< empty: default
    Truth* truth = nullptr; ///< null on a real server
};

struct Progress {
    double percent = 0.0;
    Seconds now{0.0};
    std::optional<Seconds> time_left;
    std::string state;
};

/// Drives a RobotSession through connect, spawn, behavior and export. Lives in the thread of its event loop.
class MissionRunner : public QObject {
    Q_OBJECT
public:
    MissionRunner(Mission mission, const agent::PluginLoader& plugins, RunOptions options, QObject* parent = nullptr);
    ~MissionRunner() override;

    void start();
    /// Ctrl+C: stops the robot, keeps what was scanned.
    void interrupt();
    /// Keys of the JSON summary (README); valid after `finished`.
    const QJsonObject& summary() const { return summary_; }

signals:
    void progressed(const usar::mission::Progress& progress);
    /// 0 done, 1 mission failed, 2 bad use or input.
    void finished(int exit_code);

private:
    struct Private;
    std::unique_ptr<Private> d_;
    QJsonObject summary_;
};

} // namespace usar::mission
