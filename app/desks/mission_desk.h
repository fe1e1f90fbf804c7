// Mission files: opening one sets up its world, robot, behavior and area; saving one stores the current setup.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/desks/desk.h"
#include "app/desks/server_desk.h"
#include "app/desks/task_desk.h"
#include "core/server/embedded/program_files.h"

namespace usar::app {

/// A mission may have to wait for its world, which is loaded first, or for the process of its behavior's plugin.
/// Belongs to the GUI thread.
class MissionDesk : public Desk {
    Q_OBJECT
public:
    MissionDesk(const DeskContext& context, ServerDesk& server, TaskDesk& task)
        : Desk(context)
        , server_(server)
        , task_(task) {}

    void registerCommands() override;
    void wire() override;

    void openMission(const QString& path);
    /// Saves the task that is set up for the selected robot.
    void saveMission(const QString& path);
    /// The task that is set up for the selected robot, as a mission of this name. The error says what is missing.
    Result<mission::Mission> setUpNow(const std::string& name) const;
    /// Name of the mission that was set up last, if its area and its world are still those that are set up; else empty.
    std::string name() const;
    /// Sets up a mission that waited for a plugin; call it when plugins have changed.
    void takePlugins();
    /// Flies what is left of a mission that was cut off, as soon as its world is there.
    void flyRest(const std::shared_ptr<const mission::RecordedScan>& earlier);
    /// Drops the mission that waits for its world, if any.
    void forgetAwaitedWorld() { awaiting_world_.reset(); }

signals:
    /// A mission was read from this file or saved to it.
    void fileUsed(const QString& path);

private:
    /// Looks for the next mission in the folder of this one.
    void remember(const QString& path);
    /// Returns the mission's world if the embedded simulator runs a different one without robots; else empty.
    QString worldToOpenFor(const mission::Mission& mission) const;
    /// Selects a robot and the behavior, and sets up the task. Waits while the behavior's plugin is still being loaded.
    /// Errors are notices.
    void setUp(const mission::Mission& mission);
    /// Selects the robot that fits: the selected one, or another one of the class that has nothing to do; else none,
    /// and the next robot that is spawned will be of that class.
    void selectRobotFor(const std::string& robot_class);
    /// Starts the rests of missions if their world is there; opens it if another one is.
    void flyRests();

    ServerDesk& server_;
    TaskDesk& task_;
    QString folder_ = server::missionsFolder(); ///< where the user looks for missions
    std::string start_; ///< start pose of the mission that was set up last, for a robot that is not there yet
    std::optional<mission::Mission> last_; ///< It was set up last.
    std::optional<mission::Mission> awaiting_world_;
    std::optional<mission::Mission> awaiting_plugin_;
    std::vector<std::shared_ptr<const mission::RecordedScan>> rests_; ///< they wait for a link, or for their world
};

} // namespace usar::app
