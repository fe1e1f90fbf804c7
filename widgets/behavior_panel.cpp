#include "widgets/behavior_panel.h"

#include <utility>

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

#include "widgets/icons.h"
#include "widgets/theme.h"

namespace usar::widgets {

namespace {

QLabel* mutedLabel(const QString& text = {}) {
    auto* label = new QLabel(text);
    label->setProperty("role", "muted");
    label->setWordWrap(true);
    return label;
}

} // namespace

BehaviorPanel::BehaviorPanel(QWidget* parameter_form, QWidget* parent)
    : QWidget(parent)
    , robot_label_(new QLabel)
    , behavior_box_(new QComboBox)
    , help_label_(mutedLabel())
    , area_form_(new AreaForm)
    , area_tool_(new QToolButton)
    , summary_label_(mutedLabel())
    , start_(new QPushButton(tr("Start")))
    , pause_(new QPushButton(tr("Pause")))
    , land_(new QPushButton(tr("Land now")))
    , stop_(new QPushButton(tr("Stop"))) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(gap::small, gap::small, gap::small, gap::small);
    layout->setSpacing(gap::small);
    robot_label_->setProperty("role", "title");
    behavior_box_->setAccessibleName(tr("Behavior"));
    behavior_box_->setToolTip(tr("What the selected robot should do"));
    layout->addWidget(robot_label_);
    layout->addWidget(behavior_box_);
    layout->addWidget(help_label_);
    layout->addWidget(makeAreaBox());
    layout->addWidget(summary_label_);
    layout->addWidget(parameter_form, 1);
    layout->addWidget(makeButtons());
    connect(behavior_box_, &QComboBox::currentIndexChanged, this, [this](int index) {
        help_label_->setText(behavior_box_->itemData(index, Qt::ToolTipRole).toString());
        emit behaviorChosen(QString::fromStdString(behaviorId()));
    });
    setRunState(RunState::NoRobot, {});
}

QWidget* BehaviorPanel::makeAreaBox() {
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(gap::tiny);
    auto* row = new QHBoxLayout;
    auto* title = new QLabel(tr("Mission area"));
    title->setProperty("role", "title");
    area_tool_->setIcon(icon("area"));
    area_tool_->setText(tr("Draw"));
    area_tool_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    area_tool_->setCheckable(true);
    area_tool_->setToolTip(tr("Draw the mission area on the map (A)"));
    row->addWidget(title, 1);
    row->addWidget(area_tool_);
    layout->addLayout(row);
    layout->addWidget(area_form_);
    connect(area_tool_, &QToolButton::clicked, this, &BehaviorPanel::areaToolToggled);
    connect(area_form_, &AreaForm::areaChanged, this, &BehaviorPanel::areaTyped);
    return box;
}

QWidget* BehaviorPanel::makeButtons() {
    auto* box = new QWidget;
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(gap::tiny);
    start_->setProperty("role", "primary");
    start_->setIcon(icon("play", tokens().on_fill));
    pause_->setIcon(icon("pause"));
    land_->setIcon(icon("land"));
    stop_->setIcon(icon("stop"));
    pause_->setCheckable(true);
    start_->setToolTip(tr("Start the behavior with this area and these parameters (Ctrl+Return)"));
    pause_->setToolTip(tr("Hold position; press again to go on (Space)"));
    land_->setToolTip(tr("Land here and now; what was scanned is kept (L)"));
    stop_->setToolTip(tr("End the behavior; the robot stops where it is"));
    grid->addWidget(start_, 0, 0, 1, 3);
    grid->addWidget(pause_, 1, 0);
    grid->addWidget(land_, 1, 1);
    grid->addWidget(stop_, 1, 2);
    connect(start_, &QPushButton::clicked, this, &BehaviorPanel::startRequested);
    connect(pause_, &QPushButton::clicked, this, &BehaviorPanel::pauseRequested);
    connect(land_, &QPushButton::clicked, this, &BehaviorPanel::landRequested);
    connect(stop_, &QPushButton::clicked, this, &BehaviorPanel::stopRequested);
    return box;
}

void BehaviorPanel::setBehaviors(const std::vector<agent::BehaviorDescription>& behaviors) {
    const std::string chosen = behaviorId();
    {
        const QSignalBlocker blocker(behavior_box_);
        behavior_box_->clear();
        for (const agent::BehaviorDescription& behavior : behaviors) {
            behavior_box_->addItem(QString::fromStdString(behavior.name), QString::fromStdString(behavior.id));
            behavior_box_->setItemData(behavior_box_->count() - 1, QString::fromStdString(behavior.help),
                                       Qt::ToolTipRole);
        }
    }
    behavior_box_->setEnabled(!behaviors.empty());
    const int index = behavior_box_->findData(QString::fromStdString(chosen));
    behavior_box_->setCurrentIndex(index >= 0 ? index : 0);
    emit behavior_box_->currentIndexChanged(behavior_box_->currentIndex());
}

void BehaviorPanel::chooseBehavior(const std::string& id) {
    const int index = behavior_box_->findData(QString::fromStdString(id));
    if (index >= 0)
        behavior_box_->setCurrentIndex(index);
}

std::string BehaviorPanel::behaviorId() const {
    return behavior_box_->currentData().toString().toStdString();
}

void BehaviorPanel::setPlanSummary(const QString& summary) {
    summary_label_->setText(summary);
}

void BehaviorPanel::setAreaToolActive(bool active) {
    area_tool_->setChecked(active);
}

bool BehaviorPanel::setRunState(RunState state, const QString& robot_name) {
    const bool running = state == RunState::Running || state == RunState::Paused;
    robot_label_->setText(robot_name.isEmpty()         ? tr("No robot yet: double-click a start pose")
                          : state == RunState::NoRobot ? tr("%1 is not spawned").arg(robot_name)
                                                       : robot_name);
    if (std::exchange(run_state_, state) == state)
        return false;
    start_->setEnabled(state == RunState::Ready);
    pause_->setEnabled(running);
    pause_->setChecked(state == RunState::Paused);
    pause_->setText(state == RunState::Paused ? tr("Resume") : tr("Pause"));
    land_->setEnabled(running);
    stop_->setEnabled(running);
    behavior_box_->setEnabled(!running && behavior_box_->count() > 0);
    return true;
}

} // namespace usar::widgets
