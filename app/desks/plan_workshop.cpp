#include "app/desks/plan_workshop.h"

#include <QFileInfo>
#include <QStandardPaths>

#include "core/mission/files/mission_check.h"
#include "widgets/panels/dialogs.h"

namespace usar::app {

PlanWorkshop::~PlanWorkshop() {
    delete editor_;
}

void PlanWorkshop::registerCommands() {
    add("plan.open", [this] { choosePlanFile(); });
    add("plan.edit", [this] { editPlan(); });
    add("plan.new", [this] { startNew(); });
}

void PlanWorkshop::wire() {
    connect(&selection_, &Selection::changed, this, &PlanWorkshop::follow);
    connect(&views_.behavior->plan(), &widgets::PlanChoice::openRequested, this, &PlanWorkshop::choosePlanFile);
    connect(&views_.behavior->plan(), &widgets::PlanChoice::editRequested, this, &PlanWorkshop::editPlan);
    connect(&views_.behavior->plan(), &widgets::PlanChoice::chosen, this, [this] { emit planChosen(); });
}

void PlanWorkshop::restore(const QSettings& settings) {
    geometry_ = settings.value("plan_editor/geometry").toByteArray();
}

void PlanWorkshop::save(SettingsSheet& settings) const {
    settings.setValue("plan_editor/geometry", editor_ ? editor_->saveGeometry() : geometry_);
}

widgets::PlanEditor& PlanWorkshop::opened() {
    if (editor_)
        return *editor_;
    editor_ = new widgets::PlanEditor;
    editor_->setWindowFlag(Qt::Window);
    editor_->setAttribute(Qt::WA_QuitOnClose, false); // It belongs to the main window.
    editor_->setObjectName("plan_editor");
    editor_->setKeepingFolder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/plans");
    if (!editor_->restoreGeometry(geometry_))
        editor_->resize(editor_->sizeHint());
    connectEditor();
    follow();
    return *editor_;
}

void PlanWorkshop::connectEditor() {
    using widgets::PlanEditor;
    connect(editor_, &PlanEditor::openRequested, this, &PlanWorkshop::choosePlanFile);
    connect(editor_, &PlanEditor::applyRequested, this, &PlanWorkshop::putIntoRobot);
    connect(editor_, &PlanEditor::saved, this, &PlanWorkshop::takeSaved);
    connect(editor_, &PlanEditor::exported, this, &PlanWorkshop::tellExported);
    connect(editor_, &PlanEditor::failed, this, &PlanWorkshop::complain);
}

void PlanWorkshop::show() {
    opened().show();
    editor_->raise();
    editor_->activateWindow();
}

void PlanWorkshop::load(const QString& path) {
    if (editor_ && editor_->path() == path) {
        checkForChosen();
        return show();
    }
    opened().letGo([this, path] {
        if (const auto read = editor_->open(path); !read)
            return complain(read.error());
        checkForChosen();
        show();
    });
}

std::string PlanWorkshop::chosenClass() const {
    const auto* described = control_.plugins().robotOf(plannedBehavior());
    return described ? described->class_name : std::string();
}

void PlanWorkshop::checkForChosen() {
    const auto* described = control_.plugins().robotOf(plannedBehavior());
    if (const std::string name = chosenClass(); checked_for_ != name) {
        editor_->setPrimitives(described ? described->primitives : std::vector<agent::PrimitiveDescription>());
        checked_for_ = name;
    }
    follow();
}

std::string PlanWorkshop::plannedBehavior() const {
    return mission::plannedBehavior(views_.behavior->behaviorId(), control_.plugins());
}

void PlanWorkshop::openPlan(const QString& path) {
    const std::string behavior_id = plannedBehavior();
    emit fileUsed(path);
    if (const auto plan = mission::readOwnPlan(path, behavior_id, control_.plugins())) {
        if (editor_ && editor_->isVisible())
            load(path);
        return use(behavior_id, path);
    } else if (complain(plan.error()); QFileInfo(path).isReadable()) {
        load(path);
    }
}

void PlanWorkshop::use(const std::string& behavior_id, const QString& path) {
    views_.behavior->chooseBehavior(behavior_id);
    views_.behavior->plan().choose(path);
    emit planChosen();
    notices_.cure("plan");
    notices_.say(Severity::Note, "plan-ready",
                 tr("%1 is used from the next start on.").arg(QFileInfo(path).fileName()));
}

void PlanWorkshop::choosePlanFile() {
    widgets::askForFile(window_, tr("Open plan"), views_.behavior->plan().path(),
                        tr("POSH plans (*.lap *.posh);;All files (*)"),
                        [this](const QString& path) { openPlan(path); });
}

void PlanWorkshop::editPlan() {
    const QString path = views_.behavior->plan().path();
    const auto* behavior = control_.plugins().behavior(plannedBehavior());
    if (!path.isEmpty())
        load(path);
    else if (behavior && !behavior->plan_name.empty())
        edit(behavior->plan_text, QString::fromStdString(behavior->plan_name));
    else
        startNew();
}

void PlanWorkshop::edit(const std::string& text, const QString& name) {
    if (editor_ && editor_->path().isEmpty() && editor_->name() == name)
        return show();
    startWith(text, name);
}

void PlanWorkshop::startWith(const std::string& text, const QString& name) {
    opened().letGo([this, text, name] {
        editor_->setText(text, name);
        checkForChosen();
        show();
    });
}

void PlanWorkshop::takeSaved(const QString& path) {
    emit fileUsed(path);
    notices_.cure("plan");
    const std::string behavior_id = plannedBehavior();
    if (checked_for_ != chosenClass())
        notices_.say(Severity::Note, "plan-ready",
                     tr("Saved %1. It is not for the robot that is selected now, and so not used by it.")
                         .arg(QFileInfo(path).fileName()));
    else if (mission::readOwnPlan(path, behavior_id, control_.plugins()))
        use(behavior_id, path);
    else
        notices_.say(Severity::Note, "plan-ready",
                     tr("Saved %1. It does not fit the robot yet and is not used.").arg(QFileInfo(path).fileName()));
}

void PlanWorkshop::tellExported(const QString& path, const QStringList& lacks) {
    notices_.say(lacks.isEmpty() ? Severity::Note : Severity::Warning, "plan-export",
                 lacks.isEmpty() ? tr("Exported the plan as %1.").arg(path)
                                 : tr("Exported the plan as %1; that dialect lacks: %2").arg(path, lacks.join("; ")));
}

void PlanWorkshop::putIntoRobot(const std::string& text, const QString& name) {
    if (Robot* robot = selection_.robot(); robot && robot->running())
        robot->control(agent::ReplacePlan{{name.toStdString(), text}});
}

void PlanWorkshop::follow() {
    if (!editor_)
        return;
    if (checked_for_ && checked_for_->empty() && !chosenClass().empty())
        return checkForChosen(); // The plan was opened for no robot, so it gets the first one.
    const Robot* robot = selection_.robot();
    const auto* behavior = robot ? control_.plugins().behavior(robot->view().behavior_id) : nullptr;
    const auto* described = behavior ? control_.plugins().robotOf(behavior->id) : nullptr;
    const bool planned = behavior && !behavior->plan_name.empty();
    const bool fits = described && checked_for_ == described->class_name;
    editor_->setApplicable(robot && robot->running() && planned && fits,
                           !robot || !robot->running()
                               ? tr("No robot runs; save the plan, and it is used at the next start")
                           : planned ? tr("This plan is for another kind of robot")
                                     : tr("No plan controls this robot now"));
    if (robot && fits)
        editor_->setRunningPlan(nameOf(*robot), running_text_);
    else
        editor_->setRunningPlan({}, {});
}

void PlanWorkshop::setRunningPlan(const std::string& text) {
    running_text_ = text;
    follow();
}

} // namespace usar::app
