// The window as a person meets it: what can be clicked, dragged, typed and read, by the words on it.
#pragma once

#include <memory>

#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "app/main_window.h"

/// A window of its own with settings and results in a temporary folder, connected to an embedded simulator on a free
/// port. Gestures go through QTest's mouse and key events only.
class WindowPage {
public:
    explicit WindowPage(const QString& result_folder = {});

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
    void screenshot(const QString& name);

    QString connectionText() { return window_->views().connection->statusText(); }
    std::size_t knownTiles() const;
    const usar::app::RobotView* robot(int id) const;

private:
    QPoint onMap(const usar::Vec2& point_in_map_m);
    QPoint startPoseOnMap(const std::string& name);

    QTemporaryDir folder_;
    QString result_folder_;
    std::unique_ptr<usar::app::MainWindow> window_;
};
