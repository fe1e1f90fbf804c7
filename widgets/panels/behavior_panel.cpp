#include "widgets/panels/behavior_panel.h"

#include <algorithm>
#include <utility>

#include <QSignalBlocker>

#include "widgets/style/icons.h"
#include "widgets/style/scroll_box.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"

namespace usar::widgets {

namespace {

/// Compares everything that the panel shows except the name.
bool looksLike(const agent::BehaviorDescription& one, const agent::BehaviorDescription& other) {
    return one.id == other.id && one.help == other.help && one.needs_area == other.needs_area &&
           one.plan_name == other.plan_name;
}

} // namespace

BehaviorPanel::BehaviorPanel(QWidget* parameter_form, QWidget* parent) : QWidget(parent) {
    robot_label_->setProperty("role", "title");
    for (QLabel* label : {robot_label_, help_label_, summary_label_})
        label->setWordWrap(true);
    named(behavior_box_, tr("Behavior"), tr("What the selected robot should do"));
    behavior_box_->setMinimumHeight(minimum_target);
    rescan_->hide();
    isolated_->setToolTip(
        tr("If a behavior crashes or hangs in its own process, only its robot stops; you are told where it failed, and "
           "nothing else is affected. Costs well under a millisecond per tick"));
    adjust_->setToolTip(tr("What was scanned twice shows how the INS has drifted. In flight, new scans are placed by "
                           "that; at landings and "
                           "at the end, the map is made again with the corrected path. Otherwise it is the thesis's "
                           "map, as it was flown"));
    for (QCheckBox* box : {isolated_, adjust_})
        box->setMinimumHeight(minimum_target);
    connect(adjust_, &QCheckBox::clicked, this, &BehaviorPanel::adjustChosen);
    connect(isolated_, &QCheckBox::clicked, this, &BehaviorPanel::isolationChosen);
    makeAreaBox();
    auto* column = laidOut(new QVBoxLayout(content_), {}, gap::small, {robot_label_});
    auto* row = laidOut(new QHBoxLayout, gap::tiny, {behavior_box_, rescan_});
    row->setStretchFactor(behavior_box_, 1);
    column->addLayout(row);
    laidOut(column, gap::small, {help_label_, plan_, isolated_, adjust_});
    column->addLayout(makeLimitRow());
    laidOut(column, gap::small, {area_box_, summary_label_, parameter_form});
    column->setStretchFactor(parameter_form, 1);
    // Start must be seen in the smallest window, so the rest scrolls above it.
    laidOut(new QVBoxLayout(this), {gap::small, gap::small, gap::small, gap::small}, gap::small,
            {scroll_ = new ScrollBox(content_), makeButtons()})
        ->setStretchFactor(scroll_, 1);
    summary_label_->hide();
    connect(behavior_box_, &QComboBox::currentIndexChanged, this, [this] {
        showBehavior();
        emit behaviorChosen(QString::fromStdString(behaviorId()));
    });
    setRunState(RunState::NoRobot, {});
}

QLayout* BehaviorPanel::makeLimitRow() {
    auto* const label = new QLabel(tr("Time limit"));
    label->setBuddy(limit_);
    limit_->setSpecialValueText(tr("none"));
    limit_->setSuffix(tr(" h"));
    limit_->setDecimals(6);     // A limit in a file may be one of seconds.
    limit_->setRange(0.0, 1e4); // No mission file has more.
    limit_->setMinimumHeight(minimum_target);
    const QString help = tr("Simulated time after which the behavior is ended; 0: never");
    named(limit_, tr("Time limit"), help);
    tellRange(limit_, help);
    auto* const row = laidOut(new QHBoxLayout, -1, {label, limit_});
    row->setStretchFactor(label, 1);
    connect(limit_, &QuantityBox::valueChanged, this, [this] { emit limitChosen(limit_h()); });
    return row;
}

std::optional<double> BehaviorPanel::limit_h() const {
    return limit_->value() > 0.0 ? std::optional(limit_->value()) : std::nullopt;
}

void BehaviorPanel::setLimit(const std::optional<double>& hours) {
    const QSignalBlocker blocker(limit_);
    limit_->setValue(hours.value_or(0.0));
}

void BehaviorPanel::makeAreaBox() {
    auto* title = new QLabel(tr("Mission area"));
    title->setProperty("role", "title");
    area_tool_->setIcon(icon("area"));
    area_tool_->setText(tr("Draw"));
    area_tool_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    area_tool_->setCheckable(true);
    area_tool_->setMinimumHeight(minimum_target);
    area_tool_->setToolTip(tr("Draw the mission area on the map (A)"));
    auto* row = laidOut(new QHBoxLayout, -1, {title, area_tool_});
    row->setStretchFactor(title, 1);
    auto* column = laidOut(new QVBoxLayout(area_box_), {}, gap::tiny);
    column->addLayout(row);
    column->addWidget(area_form_);
    connect(area_tool_, &QToolButton::clicked, this, &BehaviorPanel::areaToolToggled);
    connect(area_form_, &AreaForm::areaChanged, this, &BehaviorPanel::areaTyped);
}

QWidget* BehaviorPanel::makeButtons() {
    auto* box = new QWidget;
    auto* grid = gridOf(box, {}, gap::tiny, gap::tiny);
    start_->setProperty("role", "primary");
    start_->setIcon(icon("play", tokens().on_fill));
    pause_->setIcon(icon("pause"));
    land_->setIcon(icon("land"));
    stop_->setIcon(icon("stop"));
    pause_->setCheckable(true);
    start_->setStatusTip(tr("Start the behavior with this area and these parameters"));
    pause_->setStatusTip(tr("Hold position; press again to continue"));
    land_->setStatusTip(tr("Land here and now; what was scanned is kept"));
    stop_->setStatusTip(tr("End the behavior; the robot stops where it is"));
    for (QPushButton* button : buttons()) {
        // A click leaves the focus on the map, where the arrow keys pan; Tab still reaches the button.
        button->setFocusPolicy(Qt::TabFocus);
        button->setToolTip(button->statusTip());
        button->setMinimumHeight(minimum_target);
        button->setEnabled(false);
    }
    grid->addWidget(start_, 0, 0, 1, 3);
    grid->addWidget(pause_, 1, 0);
    grid->addWidget(land_, 1, 1);
    grid->addWidget(stop_, 1, 2);
    return box;
}

void BehaviorPanel::setActions(QAction* start, QAction* pause, QAction* land, QAction* stop) {
    QAction* const actions[] = {start, pause, land, stop};
    for (std::size_t i = 0; i < buttons().size(); ++i) {
        QPushButton* button = buttons()[i];
        QAction* action = actions[i];
        const auto show = [this, button, action] {
            const QString keys = action->shortcut().toString(QKeySequence::NativeText);
            button->setToolTip(keys.isEmpty() ? button->statusTip()
                                              : QStringLiteral("%1 (%2)").arg(button->statusTip(), keys));
            button->setVisible(action->isVisible());
            follow(button, action);
        };
        connect(action, &QAction::changed, button, show);
        connect(button, &QPushButton::clicked, this, [this, action] {
            action->trigger();
            pause_->setChecked(run_state_ == RunState::Paused); // The state of the robot counts, not the click.
        });
        show();
    }
}

void BehaviorPanel::setRescanAction(QAction* action) {
    showAction(rescan_, action);
    rescan_->setMinimumSize(minimum_target, minimum_target);
    rescan_->setFocusPolicy(Qt::TabFocus);
    rescan_->show();
}

void BehaviorPanel::follow(QPushButton* button, const QAction* action) {
    if (action->isEnabled() || !button->hasFocus())
        return button->setEnabled(action->isEnabled());
    // Qt would move the focus of a disabled button to an arbitrary widget; by the next turn of the event loop its
    // neighbor is enabled and can take the focus.
    QMetaObject::invokeMethod(
        button,
        [this, button, action] {
            if (action->isEnabled())
                return;
            const auto all = buttons();
            const auto next = std::ranges::find_if(
                all, [&](const QPushButton* other) { return other != button && other->isEnabled(); });
            if (next != all.end())
                (*next)->setFocus(Qt::OtherFocusReason);
            button->setEnabled(false);
        },
        Qt::QueuedConnection);
}

void BehaviorPanel::setBehaviors(const std::vector<agent::BehaviorDescription>& behaviors) {
    const std::string chosen = behaviorId();
    const auto before = std::exchange(behaviors_, behaviors);
    {
        const QSignalBlocker blocker(behavior_box_);
        behavior_box_->clear();
        for (const agent::BehaviorDescription& behavior : behaviors_) {
            behavior_box_->addItem(QString::fromStdString(behavior.name), QString::fromStdString(behavior.id));
            behavior_box_->setItemData(behavior_box_->count() - 1, QString::fromStdString(behavior.help),
                                       Qt::ToolTipRole);
        }
        const int index = behavior_box_->findData(QString::fromStdString(chosen));
        behavior_box_->setCurrentIndex(index >= 0 ? index : 0);
    }
    lockChoices();
    const auto old = std::ranges::find(before, behaviorId(), &agent::BehaviorDescription::id);
    if (old == before.end() || !looksLike(*old, behaviors_[static_cast<std::size_t>(behavior_box_->currentIndex())]))
        showBehavior();
    if (behaviorId() != chosen)
        emit behaviorChosen(QString::fromStdString(behaviorId()));
}

void BehaviorPanel::lockChoices() {
    const bool open = !busy() && behavior_box_->count() > 0;
    for (QWidget* const widget : std::initializer_list<QWidget*>{behavior_box_, isolated_, adjust_, limit_})
        widget->setEnabled(open);
}

/// Shows what depends on the chosen behavior: its help, its plan, its area.
void BehaviorPanel::showBehavior() {
    const int row = behavior_box_->currentIndex();
    area_box_->setVisible(needsArea());
    adjust_->setVisible(needsArea()); // Others make no map.
    if (row < 0) {
        help_label_->setText(
            tr("No plugin has a behavior for this kind of robot. You can drive it with Messages > Type "
               "a raw command."));
        plan_->setBehavior({}, {});
        return fitHelp();
    }
    const agent::BehaviorDescription& shown = behaviors_[static_cast<std::size_t>(row)];
    help_label_->setText(QString::fromStdString(shown.help));
    behavior_box_->setToolTip(tr("What the selected robot should do\n%1").arg(help_label_->text()));
    plan_->setBehavior(shown.id, QString::fromStdString(shown.plan_name));
    fitHelp();
}

void BehaviorPanel::fitHelp() {
    constexpr int a_parameter_px = 40; // In addition to the minimum height of the form.
    const QSize room = scroll_->size();
    const int needed_px = content_->layout()->totalMinimumHeightForWidth(room.width());
    const int help_px = help_label_->heightForWidth(room.width()) + gap::small;
    const int without_px = help_label_->isHidden() ? needed_px : needed_px - help_px;
    help_label_->setHidden(without_px + help_px + a_parameter_px > room.height());
}

void BehaviorPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitHelp();
}

bool BehaviorPanel::needsArea() const {
    const int row = behavior_box_->currentIndex();
    return row < 0 || behaviors_[static_cast<std::size_t>(row)].needs_area;
}

void BehaviorPanel::chooseBehavior(const std::string& id) {
    const int index = behavior_box_->findData(QString::fromStdString(id));
    if (index >= 0)
        behavior_box_->setCurrentIndex(index);
}

void BehaviorPanel::setPlanSummary(const QString& summary) {
    summary_label_->setText(summary);
    summary_label_->setVisible(!summary.isEmpty());
    fitHelp();
}

bool BehaviorPanel::setRunState(RunState state, const QString& robot_name) {
    robot_label_->setText(robot_name.isEmpty()         ? tr("No robot yet: double-click a start pose")
                          : state == RunState::NoRobot ? tr("%1 is not spawned").arg(robot_name)
                          : state == RunState::Replay  ? tr("%1: nothing can be started").arg(robot_name)
                                                       : robot_name);
    if (std::exchange(run_state_, state) == state)
        return false;
    pause_->setChecked(state == RunState::Paused);
    pause_->setText(state == RunState::Paused ? tr("Resume") : tr("Pause"));
    lockChoices();
    return true;
}

} // namespace usar::widgets
