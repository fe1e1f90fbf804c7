// What a robot's camera sees, how fresh it is, and the controls that zoom and turn the camera.
#pragma once

#include <QComboBox>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QSlider>
#include <QTimer>
#include <QWidget>

class QAction;

namespace usar::widgets {

class CameraCanvas;
class EmptyState;

/// Angles of view of the shown camera.
struct CameraZoom {
    double now_rad = 1.396;
    double smallest_rad = 0.349;
    double largest_rad = 2.094;
    bool operator==(const CameraZoom&) const = default;
};

/// Pictures in, wishes out. While hidden it wants no pictures and says so. GUI thread.
class CameraView : public QWidget {
    Q_OBJECT
public:
    explicit CameraView(QWidget* parent = nullptr);

    void setPicture(const QImage& picture, double frames_per_s);
    const QImage& picture() const;
    /// Since the program began.
    int pictureCount() const { return pictures_; }
    /// "R1 · Camera", and the cameras that can be chosen instead of that one.
    void setSource(const QString& robot, const QStringList& cameras, const QString& shown);
    void setZoom(const CameraZoom& zoom);
    /// Instead of a picture: what is missing and what to do. Ends with the next picture.
    void setEmpty(const QString& title, const QString& hint, QAction* action = nullptr);
    bool isEmpty() const;
    /// As tool buttons in the row of controls, in this order.
    void setActions(const QList<QAction*>& actions);
    /// False while another tab covers it: Qt hides nothing then.
    void setUncovered(bool uncovered);
    bool wantsPictures() const { return uncovered_ && isVisible(); }
    QSize sizeHint() const override { return {340, 330}; }

signals:
    void zoomRequested(double field_of_view_rad);
    /// How far to look to the right and up.
    void turnRequested(double right_rad, double up_rad);
    void cameraChosen(const QString& name);
    /// It was shown or hidden.
    void wantsPicturesChanged(bool wants);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void makeControls();
    void showAge();
    void watchedOrNot();
    void askZoom(double field_of_view_rad);

    CameraCanvas* canvas_;
    EmptyState* empty_;
    QLabel* source_;
    QLabel* freshness_;
    QComboBox* cameras_;
    QSlider* slider_;
    QLabel* angle_;
    QHBoxLayout* controls_;
    QTimer age_timer_;
    QElapsedTimer age_;
    CameraZoom zoom_;
    double frames_per_s_ = 0.0;
    int pictures_ = 0;
    bool uncovered_ = true;
};

} // namespace usar::widgets
