// The card above the map that tells how a mission ended.
#pragma once

#include <QFrame>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "widgets/models/mission_outcome.h"

namespace usar::widgets {

/// Hidden until `tell`, and after it was closed. GUI thread.
class ResultCard : public QFrame {
    Q_OBJECT
public:
    explicit ResultCard(QWidget* parent = nullptr);

    /// Tells this outcome in place of the one before, without a picture yet.
    void tell(const MissionOutcome& outcome);
    /// Shows pictures of the map from above and in perspective, no larger than `picture_px`; a null one is not shown.
    void setPictures(const QImage& map, const QImage& relief);
    /// False: the robot is gone and cannot fly again.
    void setCanFlyAgain(bool can) { again_->setVisible(can); }

    static constexpr QSize picture_px{140, 92};
    /// Without the pictures, for which a narrow window has no room.
    QSize minimumSizeHint() const override { return {300, QFrame::minimumSizeHint().height()}; }

signals:
    void folderRequested(const QString& path);
    void pictureRequested(const QString& path);
    void flyAgainRequested();
    /// To compare this run with others; `summary` is the path of its summary.
    void compareRequested(const QString& summary);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void lay();
    void showFigures();
    void showPictures(); ///< as many as there is room for, the map first

    MissionOutcome outcome_;
    QLabel* picture_ = new QLabel(this);
    QLabel* relief_ = new QLabel(this);
    QLabel* title_ = new QLabel(this);
    QLabel* reason_ = new QLabel(this);
    QLabel* figures_ = new QLabel(this);
    QPushButton* folder_ = new QPushButton(tr("Open folder"), this);
    QPushButton* open_picture_ = new QPushButton(tr("Open picture"), this);
    QPushButton* again_ = new QPushButton(tr("Fly again"), this);
    QPushButton* compare_ = new QPushButton(tr("Compare"), this);
    QToolButton* close_ = new QToolButton(this);
};

} // namespace usar::widgets
