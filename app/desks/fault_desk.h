// Desk of the faults dock: makes things go wrong in the embedded simulator on request.
#pragma once

#include <string>
#include <vector>

#include "app/desks/desk.h"

namespace usar::app {

/// Lists the simulator's faults, and adds and ends them. GUI thread.
class FaultDesk : public Desk {
    Q_OBJECT
public:
    using Desk::Desk;

    void registerCommands() override;
    void wire() override;
    /// Adds a mission's faults (texts in the syntax of --fault), with times relative to now. Equal faults of an earlier
    /// start that are not over are ended first, because two winds would blow twice as hard.
    void begin(const QStringList& faults);
    /// Texts of the faults that are not over, with times relative to now; of an active one, only the rest is told.
    std::vector<std::string> texts() const;

private:
    /// Adds the fault that is set up in the panel.
    void inject();
    /// Enables the panel while the embedded simulator runs, and fills its lists of robots and sensors.
    void showChoices();
    void list(const std::vector<sim::FaultStatus>& faults);

    std::vector<sim::FaultStatus> faults_; ///< all faults of the embedded simulator, including those that are over
    Seconds now_{0.0};                     ///< The simulator's clock showed this when it was last told.
};

} // namespace usar::app
