#include "tests/e2e/window_page.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QSettings>
#include <QSpinBox>
#include <QUrl>

#include "core/link/recording_reader.h"
#include "widgets/panels/parameter_form.h"

using namespace usar;

WindowPage::WindowPage(const WindowSetup& setup) {
    result_folder_ = setup.result_folder.isEmpty() ? folder_.filePath("results") : setup.result_folder;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                       setup.settings_folder.isEmpty() ? folder_.filePath("settings") : setup.settings_folder);
    app::Options options;
    options.server.simulator.port = setup.simulator_port;
    options.server.simulator.channels.wireless = setup.wireless_port;
    options.result_folder = result_folder_;
    options.plugin_folders = setup.plugin_folders;
    options.mission_file = setup.mission_file;
    options.recording = setup.recording;
    options.at = setup.at;
    options.select = setup.select;
    const bool started_before = QSettings().contains("waiting_docks");
    window_ = std::make_unique<app::MainWindow>(options);
    window_->resize(1280, 800);
    window_->show();
    if (!setup.first_start && !started_before)
        showAllDocks();
    window_->activateWindow();
    window_->begin();
}

void WindowPage::showAllDocks() {
    for (QDockWidget* const dock : window_->views().docks)
        if (!QStringList{"layers", "faults", "history", "campaign", "relief"}.contains(dock->objectName()))
            dock->show();
    for (QDockWidget* const dock : window_->views().docks)
        if (QStringList{"behavior", "instruments", "plots"}.contains(dock->objectName()))
            dock->raise();
    window_->resizeDocks({window_->views().plots_dock}, {215}, Qt::Vertical);
}

bool WindowPage::hasStartPoses() {
    return !map().content().start_poses.empty();
}

QPoint WindowPage::onMap(const Vec2& point_in_map_m) {
    return map().transform().toScreen(point_in_map_m).toPoint();
}

QPoint WindowPage::startPoseOnMap(const std::string& name) {
    for (const protocol::StartPose& pose : map().content().start_poses)
        if (pose.name == name)
            return onMap(pose.pose_in_map.position_m.head<2>());
    QTest::qFail("no such start pose", __FILE__, __LINE__);
    return {};
}

void WindowPage::doubleClickStartPose(const std::string& name) {
    const QPoint at = startPoseOnMap(name);
    QTest::mouseClick(&map(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(&map(), Qt::LeftButton, {}, at);
}

void WindowPage::clickStartPose(const std::string& name) {
    QTest::mouseClick(&map(), Qt::LeftButton, {}, startPoseOnMap(name));
}

void WindowPage::drawArea(const Rectangle& area_in_map) {
    const QPoint from = onMap(area_in_map.min_m);
    const QPoint to = onMap(area_in_map.max_m);
    QTest::mousePress(&map(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&map(), (from + to) / 2);
    QTest::mouseMove(&map(), to);
    QTest::mouseRelease(&map(), Qt::LeftButton, {}, to);
}

/// As the window system does it: to the window, which finds shortcuts and the focus itself.
void WindowPage::pressKey(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    if (key < Qt::Key_Escape && modifiers == Qt::NoModifier && !map().hasFocus() &&
        !window_->views().robots->hasFocus())
        map().setFocus(); // A person clicks there first: letters work in no other place.
    QTest::keyClick(window_->windowHandle(), key, modifiers);
}

void WindowPage::press(const QString& text) {
    for (QPushButton* button : window_->findChildren<QPushButton*>())
        if (button->isVisible() && button->isEnabled() && button->text().remove('&') == text)
            return QTest::mouseClick(button, Qt::LeftButton);
    QTest::qFail(qPrintable("no button says " + text), __FILE__, __LINE__);
}

void WindowPage::chooseSpeed(const QString& text) {
    auto* speeds = window_->views().time->findChild<QComboBox*>();
    const int index = speeds->findText(text);
    if (index < 0)
        return QTest::qFail(qPrintable("no speed " + text), __FILE__, __LINE__);
    while (speeds->currentIndex() != index)
        QTest::keyClick(speeds, speeds->currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
}

void WindowPage::connectToServer(const QString& host, quint16 port) {
    auto* bar = window_->views().connection;
    if (bar->findChild<QPushButton*>()->text() != "Connect")
        QTest::mouseClick(bar->findChild<QPushButton*>(), Qt::LeftButton);
    auto* servers = bar->findChild<QComboBox*>();
    while (servers->currentText() != "Real server")
        QTest::keyClick(servers, Qt::Key_Down);
    auto* host_edit = bar->findChild<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
    host_edit->selectAll();
    QTest::keyClicks(host_edit, host);
    auto* port_box = bar->findChild<QSpinBox*>();
    port_box->selectAll();
    QTest::keyClicks(port_box, QString::number(port));
    QTest::mouseClick(bar->findChild<QPushButton*>(), Qt::LeftButton);
}

bool WindowPage::dropFile(const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window_.get(), &enter);
    if (!enter.isAccepted())
        return false;
    QDropEvent drop(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window_.get(), &drop);
    return drop.isAccepted();
}

void WindowPage::typeArea(const Rectangle& area_in_map) {
    const auto boxes = window_->views().behavior->findChild<widgets::AreaForm*>()->findChildren<QDoubleSpinBox*>();
    const std::pair<QString, double> fields[] = {{"Lowest x", area_in_map.min_m.x()},
                                                 {"Highest x", area_in_map.max_m.x()},
                                                 {"Lowest y", area_in_map.min_m.y()},
                                                 {"Highest y", area_in_map.max_m.y()}};
    for (const auto& [name, value_m] : fields)
        for (QDoubleSpinBox* box : boxes)
            if (box->accessibleName() == name) {
                box->selectAll();
                QTest::keyClicks(box, QString::number(value_m, 'f', 1));
                QTest::keyClick(box, Qt::Key_Return);
            }
}

bool WindowPage::typeParameter(const std::string& id, const QString& text) {
    for (usar::widgets::ParameterRow* row : window_->findChildren<usar::widgets::ParameterRow*>()) {
        auto* const field = row->findChild<QLineEdit*>();
        if (row->spec().id != id || !field)
            continue;
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        return true;
    }
    return false;
}

bool WindowPage::spawnAt(const std::string& start_pose) {
    const auto known = window_->control().robots().size();
    doubleClickStartPose(start_pose);
    return QTest::qWaitFor(
        [&] {
            const auto robots = window_->control().robots();
            return robots.size() > known && robots.back()->view().figures.spawned;
        },
        15000);
}

bool WindowPage::comesToRest(int id) const {
    constexpr Seconds long_enough{0.6};
    std::optional<std::pair<Vec3, Seconds>> since; // where it has been, and from when on
    return QTest::qWaitFor(
        [&] {
            if (!robot(id) || !robot(id)->base_in_map)
                return false;
            const Vec3 here_m = robot(id)->base_in_map->position_m;
            const Seconds now = robot(id)->figures.now;
            if (!since || (here_m - since->first).norm() > 0.01)
                since = {here_m, now};
            return now - since->second >= long_enough;
        },
        soon_ms);
}

QString WindowPage::notified(const QString& words) const {
    const auto* model = window_->views().notifications->model();
    for (int row = 0; row < model->rowCount(); ++row)
        if (model->row(row).text.contains(words))
            return model->row(row).text;
    return {};
}

QString WindowPage::endedRecording() const {
    const QDir folder(result_folder_);
    for (const QString& name : folder.entryList({"*.usarrec"}, QDir::Files))
        if (const auto reader = link::RecordingReader::open(folder.filePath(name)); reader && (*reader)->survey().ended)
            return folder.filePath(name);
    return {};
}

void WindowPage::screenshot(const QString& name, QWidget* of) {
    const QDir folder(QStringLiteral(USAR_BINARY_DIR "/screenshots"));
    QDir().mkpath(folder.path());
    (of ? of : window_.get())->grab().save(folder.filePath(name + ".png"));
}

std::size_t WindowPage::knownTiles() const {
    const mission::RobotView* view = robot(window_->selectedRobot());
    return view ? view->tiles.size() : 0;
}

const mission::RobotView* WindowPage::robot(RobotId id) const {
    const mission::Robot* robot = window_->control().robot(id);
    return robot ? &robot->view() : nullptr;
}
