// Desk for the user's own plans: chooses the file that a robot uses, and manages the editor.
#pragma once

#include <optional>
#include <string>

#include <QPointer>

#include "app/desks/desk.h"
#include "core/posh/edit/plan_templates.h"
#include "widgets/plan/editor/plan_editor.h"

namespace usar::app {

/// Owns the plan editor, which is made when it is first needed. It is a window of its own beside the main window, so
/// that the user can read the plan while watching the robot. GUI thread.
class PlanWorkshop : public Desk {
    Q_OBJECT
public:
    using Desk::Desk;
    ~PlanWorkshop() override;

    void registerCommands() override;
    void wire() override;
    void restore(const QSettings& settings) override;
    void save(SettingsSheet& settings) const override;

    /// Chooses this file for the robot, from its next start on. A plan that does not fit the robot is not used, but
    /// shown in the editor. Errors are notices.
    void openPlan(const QString& path);
    /// Updates the editor when another robot is selected or its behavior starts or ends: the permission to put the plan
    /// into the running robot. The plan stays with the class of robot that it was opened for.
    void follow();
    /// Sets the current plan of the selected robot; empty: no plan decides.
    void setRunningPlan(const std::string& text);
    /// True if the plan in the editor has unsaved changes.
    bool hasChanges() const { return editor_ && editor_->isModified(); }
    /// Returns nullptr until the editor is opened for the first time.
    widgets::PlanEditor* editor() const { return editor_; }

signals:
    /// Another file was chosen for the robot that is being set up.
    void planChosen();
    /// A plan was read from this file or saved to it.
    void fileUsed(const QString& path);

private:
    /// Returns the editor; makes it first if necessary.
    widgets::PlanEditor& opened();
    void connectEditor();
    void choosePlanFile();
    void editPlan();
    void startNew() { startWith(posh::planTemplates().front().text, tr("new.lap")); }
    void startWith(const std::string& text, const QString& name);
    void show();
    /// Shows this file in the editor; an error is a notice.
    void load(const QString& path);
    /// Shows a plan that has no file of its own.
    void edit(const std::string& text, const QString& name);
    void tellExported(const QString& path, const QStringList& lacks);
    /// Replaces the plan of the selected robot while it runs.
    void putIntoRobot(const std::string& text, const QString& name);
    /// Chooses a saved file for the robot if it fits.
    void takeSaved(const QString& path);
    /// Chooses behavior and file for the next start.
    void use(const std::string& behavior_id, const QString& path);
    std::string plannedBehavior() const;
    /// Class of the robot that the chosen behavior is for; empty if there is none.
    std::string chosenClass() const;
    /// From now on the plan in the editor is checked against the robot that is chosen now.
    void checkForChosen();
    void complain(const Error& error) { notices_.complain("plan", error); }

    QPointer<widgets::PlanEditor> editor_;
    QByteArray geometry_;                    ///< geometry of the editor's window when it was last closed
    std::optional<std::string> checked_for_; ///< class of the robot whose senses and acts the editor knows
    std::string running_text_;               ///< current plan of the selected robot; empty: none
};

} // namespace usar::app
