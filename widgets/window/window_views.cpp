#include "widgets/window/window_views.h"

#include <map>

#include <QToolBar>

#include "widgets/style/form_parts.h"
#include "widgets/style/scroll_box.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

QToolBar* addBar(QMainWindow& window, const QString& name, const QString& title) {
    auto* bar = window.addToolBar(title);
    bar->setObjectName(name);
    bar->setMovable(false);
    bar->setFloatable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    return bar;
}

/// Makes two bars. In a narrow window a bar hides its end; the driver's badge and the stop button must always be
/// visible, so they have a bar of their own.
void makeTopBars(QMainWindow& window, WindowViews& views) {
    auto* bar = addBar(window, "top_bar", QObject::tr("Link and time"));
    bar->addWidget(views.connection = new ConnectionBar);
    views.connection->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(views.time = new TimeBar);
    bar->addSeparator();
    bar->addWidget(views.record = new RecordBadge);
    auto* always = new QWidget;
    auto* row = laidOut(new QHBoxLayout(always), {}, gap::small);
    row->addStretch(1);
    row->addWidget(views.driver = new ControlBadge);
    views.stop_all = named(makeStopButton(QObject::tr("STOP ALL"), {}), QObject::tr("Stop all robots"),
                           commandSpec("mission.stop_all").help);
    row->addWidget(views.stop_all);
    addBar(window, "control_bar", QObject::tr("Who drives, and the stop"))->addWidget(always);
}

void makeCenter(QMainWindow& window, WindowViews& views) {
    auto* center = new QWidget;
    laidOut(new QVBoxLayout(center), {}, 0,
            {views.question = new QuestionStrip, views.hint = new HintStrip, views.progress = new ProgressStrip,
             views.saving = new ProgressStrip, views.result = new ResultCard, views.replay = new ReplayBar,
             views.map = new MapView})
        ->setStretchFactor(views.map, 1);
    views.saving->setAccessibleName(QObject::tr("Saving"));
    views.replay->hide();
    views.map->setOrientation(MapOrientation::YUp); // As in exported pictures and in GIS.
    views.spawn_card = new SpawnCard(views.map);
    window.setCentralWidget(center);
}

QWidget* makeInstruments(WindowViews& views) {
    views.instruments = new InstrumentPanel;
    views.status = views.instruments->status();
    views.laser = views.instruments->laser();
    views.terrain = views.instruments->terrain();
    views.sonars = views.instruments->sonars();
    return views.instruments;
}

/// Makes the message list, the box for raw commands below it, and a row with their counts.
QWidget* makeInspector(WindowViews& views) {
    auto* box = new QWidget;
    auto* column =
        laidOut(new QVBoxLayout(box), {}, 0, {views.messages = new MessageList, views.command_box = new CommandBox});
    column->setStretchFactor(views.messages, 1);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(gap::small, 0, gap::tiny, gap::tiny);
    row->addWidget(views.message_count = new ElidedLabel, 1); // It gives way in a narrow dock.
    row->addWidget(views.traffic = new QToolButton);
    column->addLayout(row);
    views.message_count->setFont(themeFont(FontRole::Small));
    setRole(views.message_count, "muted");
    views.message_count->setToolTip(QObject::tr("Lines in the list above"));
    views.traffic->setAutoRaise(true);
    views.traffic->setFont(themeFont(FontRole::Small));
    views.traffic->setFocusPolicy(Qt::StrongFocus);
    views.traffic->setMinimumHeight(minimum_target);
    views.traffic->setToolTip(QObject::tr("Lines of this connection; click for all figures of the link"));
    return box;
}

/// Explains each dock to "What is this?", by its object name.
QString helpOf(const QString& dock) {
    static const std::map<QString, QString> help = {
        {"robots",
         QObject::tr("All robots, with who drives each of them, their state and their battery. The one that is "
                     "selected here is shown by all other docks.")},
        {"behavior",
         QObject::tr("What the selected robot should do by itself: choose a behavior, set its parameters, and "
                     "start, pause or stop it.")},
        {"instruments",
         QObject::tr(
             "What the selected robot perceives now. It has an instrument for each of its sensors, made from what "
             "the robot itself tells. Gray and struck out: too old to be trusted, with its age.")},
        {"sensors",
         QObject::tr("Every value that the selected robot sends, with unit, age and rate. Double-click a number "
                     "to plot it.")},
        {"plots",
         QObject::tr("Curves of chosen values over the last minutes. Drag values here from the dock Sensors.")},
        {"messages", QObject::tr("Every line to and from the server, in order, with what caused each command. The box "
                                 "below sends a line of your own.")},
        {"notifications", QObject::tr("What went wrong or is worth knowing, newest first, with what to do about it.")},
        {"history",
         QObject::tr("Every edit of areas, parameters, objects, layers and layouts, in order. Click an entry to "
                     "go back to it. Gray entries were sent and cannot be taken back.")},
        {"layers", QObject::tr("Which parts of the map are shown, and how opaque each one is.")},
        {"faults", QObject::tr("Breaks sensors, links, batteries or rotors in the embedded simulator, to see how a "
                               "behavior copes.")},
        {"camera",
         QObject::tr("The picture of the selected robot's camera. Drag it to turn the camera, and use the wheel "
                     "to zoom.")},
        {"world", QObject::tr("Objects to put into the world while it runs, and a list of those that are there.")},
        {"drive",
         QObject::tr("Driving the selected robot by hand: take control, then use the keys, the pad or a gamepad.")},
        {"radio", QObject::tr("How well the robots hear each other by radio, for each pair of them.")},
        {"relief",
         QObject::tr("The height map as a surface, with trails and robots, in the colors of the map. Drag to orbit, "
                     "with Shift to pan, and use the wheel to zoom.")},
        {"campaign",
         QObject::tr("Many runs of the mission that is set up, over seeds, behaviors and faults, flown in the "
                     "background. Double-click a run to fly it here again.")},
        {"plan",
         QObject::tr("The POSH plan of the running behavior: what it does now, and why. Set breakpoints here.")},
    };
    const auto found = help.find(dock);
    return found == help.end() ? QString() : found->second;
}

void makeDocks(QMainWindow& window, WindowViews& views) {
    constexpr auto left = Qt::LeftDockWidgetArea;
    constexpr auto right = Qt::RightDockWidgetArea;
    constexpr auto bottom = Qt::BottomDockWidgetArea;
    const auto add = [&](const QString& name, const QString& title, Qt::DockWidgetArea area, QWidget* content) {
        auto* dock = new QDockWidget(title, &window);
        dock->setObjectName(name); // QMainWindow::saveState identifies it by this.
        dock->setWidget(content);
        dock->setWhatsThis(title + ": " + helpOf(name));
        window.addDockWidget(area, dock);
        return views.docks.emplace_back(dock);
    };
    views.parameters = new ParameterForm;
    views.robots_dock = add("robots", QObject::tr("Robots"), left, views.robots = new RobotList);
    auto* behavior =
        add("behavior", QObject::tr("Behavior"), left, views.behavior = new BehaviorPanel(views.parameters));
    auto* instruments = add("instruments", QObject::tr("Instruments"), right, new ScrollBox(makeInstruments(views)));
    add("sensors", QObject::tr("Sensors"), right, views.sensors = new SensorPanel);
    views.plots_dock = add("plots", QObject::tr("Plots"), bottom, views.plots = new PlotView);
    views.messages_dock = add("messages", QObject::tr("Messages"), bottom, new ScrollBox(makeInspector(views)));
    views.notifications_dock =
        add("notifications", QObject::tr("Notifications"), bottom, views.notifications = new NotificationCenter);
    views.toasts = new ToastStack(views.map, views.notifications->model());
    add("layers", QObject::tr("Layers"), left, new ScrollBox(views.layers = new LayersPanel))->hide();
    auto* faults = add("faults", QObject::tr("Faults"), left, views.faults = new FaultPanel);
    window.tabifyDockWidget(behavior, faults); // It is tall enough.
    faults->hide();
    auto* camera = add("camera", QObject::tr("Camera"), right, new ScrollBox(views.camera = new CameraView));
    window.tabifyDockWidget(instruments, camera); // The tallest place.
    instruments->raise();
    QObject::connect(camera, &QDockWidget::visibilityChanged, views.camera, &CameraView::setUncovered);
    views.world_dock = add("world", QObject::tr("World"), left, new ScrollBox(views.world = new WorldPanel));
    window.tabifyDockWidget(behavior, views.world_dock); // Both show what should happen in the world.
    views.drive_dock = add("drive", QObject::tr("Drive"), left, views.drive = new DrivePanel);
    window.tabifyDockWidget(views.world_dock, views.drive_dock);
    behavior->raise();
    views.radio_dock = add("radio", QObject::tr("Radio"), bottom, views.radio = new RadioView);
    views.plan_dock = add("plan", QObject::tr("Plan"), bottom, new ScrollBox(views.plan = new PlanPanel));
    window.tabifyDockWidget(views.plots_dock, views.plan_dock);
    window.tabifyDockWidget(views.plan_dock, views.messages_dock);
    window.tabifyDockWidget(views.messages_dock, views.notifications_dock);
    window.tabifyDockWidget(views.notifications_dock, views.radio_dock);
    auto* history = add("history", QObject::tr("History"), bottom, views.history = new HistoryPanel);
    window.tabifyDockWidget(views.radio_dock, history);
    history->hide();
    views.campaign_dock = add("campaign", QObject::tr("Campaign"), bottom, views.campaign = new CampaignPanel);
    window.tabifyDockWidget(history, views.campaign_dock);
    views.campaign_dock->hide();
    auto* relief = add("relief", QObject::tr("3D view"), bottom, views.relief = new ReliefView(*views.map));
    window.tabifyDockWidget(views.campaign_dock, relief);
    QObject::connect(relief, &QDockWidget::visibilityChanged, views.relief, &ReliefView::setUncovered);
    relief->hide();
    views.plots_dock->raise();
}

} // namespace

WindowViews makeViews(QMainWindow& window) {
    WindowViews views;
    window.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
    // The left and right docks keep their full height; the bottom docks take theirs from the map.
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    makeTopBars(window, views);
    makeCenter(window, views);
    makeDocks(window, views);
    window.resizeDocks({views.docks[0], views.docks[1]}, {110, 500}, Qt::Vertical);
    window.resizeDocks({views.docks[2], views.docks[3]}, {450, 250}, Qt::Vertical);
    window.resizeDocks({views.docks[1], views.docks[2]}, {280, 350}, Qt::Horizontal);
    window.resizeDocks({views.docks[4]}, {240}, Qt::Vertical);
    return views;
}

void adoptMessageActions(CommandRegistry& commands, const MessageActions& actions) {
    const auto adopt = [&](const QString& id, QAction* action, const QList<QKeySequence>& keys = {}) {
        commands.adopt({"messages." + id, action->text(), QObject::tr("Messages"), action->toolTip(), "", keys},
                       action);
    };
    adopt("pause", actions.pause, {QKeySequence("F8")});
    adopt("follow", actions.follow, {QKeySequence("Ctrl+Shift+End")});
    adopt("details", actions.details, {QKeySequence("Ctrl+I")});
    adopt("cause", actions.cause, {QKeySequence("Ctrl+J")});
    adopt("resend", actions.resend, {QKeySequence("Ctrl+Shift+R")});
    adopt("only_trouble", actions.only_trouble, {QKeySequence("Ctrl+Shift+F")});
    adopt("only_type", actions.only_type);
    adopt("hide_type", actions.hide_type);
    adopt("no_filter", actions.no_filter, {QKeySequence("Ctrl+Shift+A")});
    adopt("all_robots", actions.all_robots);
    adopt("copy", actions.copy, {QKeySequence::Copy});
    adopt("copy_text", actions.copy_text, {QKeySequence("Ctrl+Shift+C")});
    adopt("copy_json", actions.copy_json);
    adopt("copy_shown", actions.copy_shown);
    adopt("save", actions.save);
    adopt("clear", actions.clear);
}

} // namespace usar::widgets
