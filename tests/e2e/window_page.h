// The window as a person meets it: what can be clicked, dragged, typed and read, by the words on it.
#pragma once

#include <memory>

#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "app/window/main_window.h"
#include "tests/suite/waiting.h"

inline constexpr int soon_ms = 15000;    ///< sockets and threads on a busy machine
inline constexpr int flight_ms = 120000; ///< a robot that flies at full speed

/// What a window is started with.
struct WindowSetup {
    QString result_folder{}; ///< empty: a temporary one
    QStringList plugin_folders{};
    QString mission_file{};
    QString recording{};
    std::optional<usar::Seconds> at{}; ///< as the options of the window, like `select`
    QString select{};
    bool first_start = false;      ///< false: all docks are open, as for a person who has worked with it before
    QString settings_folder{};     ///< empty: a temporary one, that of a first start
    quint16 simulator_port = 0;    ///< 0: any free one
    quint16 wireless_port = 50000; ///< beside a real server
};

/// A window of its own with settings and results in a temporary folder, connected to an embedded simulator on a free
/// port. Gestures go through QTest's mouse and key events only.
class WindowPage {
public:
    explicit WindowPage(const WindowSetup& setup = {});

    usar::app::MainWindow& window() { return *window_; }
    usar::widgets::MapView& map() { return *window_->views().map; }
    const QString& resultFolder() const { return result_folder_; }
    /// True once start poses are on the map.
    bool hasStartPoses();

    void doubleClickStartPose(const std::string& name);
    void clickStartPose(const std::string& name);
    void drawArea(const usar::Rectangle& area_in_map);
    void pressKey(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    /// A visible, enabled button with this text anywhere in the window; fails the test where there is none.
    void press(const QString& text);
    void chooseSpeed(const QString& text);
    /// Leaves the server there is, and types the address of another.
    void connectToServer(const QString& host, quint16 port);
    /// As from a file manager; a folder, too. False where the window does not take it.
    bool dropFile(const QString& path);
    /// Into the form's four fields.
    void typeArea(const usar::Rectangle& area_in_map);
    /// Types it into the field of that parameter and leaves the field, as a person does. False where there is none.
    bool typeParameter(const std::string& id, const QString& text);
    /// Over the map's start pose, and until the robot has spoken.
    bool spawnAt(const std::string& start_pose);
    /// Until the robot's own clock is that much later; false where it is not soon.
    bool clockGoesOn(usar::Seconds by, int id = 1) const {
        return holdsWhileClockGoesOn([] { return true; }, by, id);
    }
    /// The same, with something that holds all the while.
    template <class Calm>
    bool holdsWhileClockGoesOn(Calm calm, usar::Seconds by, int id = 1) const {
        const usar::Seconds until = robot(id)->figures.now + by;
        return usar::test::holdsUntil(
            calm, [&] { return robot(id) && robot(id)->figures.now >= until; }, soon_ms);
    }
    /// Until the robot has not moved for a while of its own clock; false where it does not come to rest soon.
    bool comesToRest(int id = 1) const;
    /// The newest notification with these words, whole; empty where there is none.
    QString notified(const QString& words) const;
    /// Path of a recording in the result folder that was ended in order, which is some time after its robot went; empty
    /// until there is one.
    QString endedRecording() const;
    void screenshot(const QString& name, QWidget* of = nullptr); ///< of the window without `of`

    QString connectionText() { return window_->views().connection->statusText(); }
    std::size_t knownTiles() const;
    const usar::mission::RobotView* robot(usar::RobotId id) const;
    const usar::mission::RobotView* robot(int number) const { return robot(usar::RobotId{number}); }

private:
    void showAllDocks();
    QPoint onMap(const usar::Vec2& point_in_map_m);
    QPoint startPoseOnMap(const std::string& name);

    QTemporaryDir folder_;
    QString result_folder_;
    std::unique_ptr<usar::app::MainWindow> window_;
};
