// A person's own plans: which file decides for a robot, and the editor in which it is written.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <QMessageBox>
#include <QObject>
#include <QPointer>
#include <QSettings>

#include "app/desks/desk.h"
#include "widgets/plan/plan_editor.h"

namespace usar::app {

/// The editor is a window of its own beside the main one, for a plan is read together with what the robot does. GUI
/// thread.
class PlanWorkshop : public QObject {
    Q_OBJECT
public:
    explicit PlanWorkshop(const DeskContext& context);
    ~PlanWorkshop() override;

    void registerCommands();
    void wire();
    void restore(const QSettings& settings);
    void save(QSettings& settings) const;

    /// It decides from the next start on. One that does not fit the robot is shown in the editor, and decides nothing.
    void openPlan(const QString& path);
    /// The selected robot is another one, or it started or stopped: what the editor checks against, and whether it can
    /// hand its plan over, may be different.
    void follow();
    /// What the followed robot's plan says by now; empty: none decides.
    void setRunningPlan(const std::string& text);
    /// Of a plan, not saved.
    bool hasChanges() const;
    /// Calls `go_on` at once if nothing would be lost, else after the person has saved or discarded the changes; never
    /// if they cancel. A second request replaces the action that waits for the open question.
    void letGo(std::function<void()> go_on);
    /// Null before it was opened first.
    widgets::PlanEditor* editor() const { return editor_; }

signals:
    /// Another file decides for the robot that is set up.
    void planChosen();

private:
    widgets::PlanEditor& opened();
    void connectEditor();
    void choosePlanFile();
    void editPlan();
    void newPlan();
    void show();
    /// Shows this file in the editor; what cannot be read is said.
    void load(const QString& path);
    /// A plan without a file of its own.
    void edit(const std::string& text, const QString& name);
    void giveUp();
    void chooseWhereToSave();
    void chooseWhereToExport(posh::Dialect dialect);
    void chooseWhereToSavePicture();
    void putIntoRobot(const std::string& text, const QString& name);
    void takeSaved(const QString& path);
    void use(const std::string& behavior_id, const QString& path);
    std::string plannedBehavior() const;
    void say(Severity severity, const QString& key, const QString& text);
    void complain(const Error& error);

    MissionControl& control_;
    WindowViews& views_;
    widgets::CommandRegistry& commands_;
    Selection& selection_;
    NoticeDesk& notices_;
    QWidget* window_;
    QPointer<widgets::PlanEditor> editor_;
    QByteArray geometry_;                    ///< of the editor's window, from the last time
    std::optional<std::string> checked_for_; ///< class of the robot whose senses and acts the editor knows
    std::string running_text_;
    QPointer<QMessageBox> question_; ///< whether the plan is saved; it stands open
    std::function<void()> after_it_; ///< what is to be done when it was answered
};

} // namespace usar::app
