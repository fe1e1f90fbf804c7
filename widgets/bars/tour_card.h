// The card and the ring of the tour: what to do, and where.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

namespace usar::widgets {

/// A ring around a part of the window, which the mouse goes through. GUI thread.
class TourRing : public QWidget {
public:
    explicit TourRing(QWidget* window);

    /// Surrounds this part of the window, without touching it; an empty one hides the ring.
    void surround(const QRect& part);
    /// The pixels of the window within which the ring is drawn; it is hollow.
    QRect outside() const { return geometry(); }
    /// What is in the ring.
    QRect inside() const { return geometry().adjusted(thickness_px, thickness_px, -thickness_px, -thickness_px); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    static constexpr int thickness_px = 3;
};

/// Tells one step of the tour. A child of the window that takes no focus by itself, so that the person can do what it
/// says. GUI thread.
class TourCard : public QFrame {
    Q_OBJECT
public:
    explicit TourCard(QWidget* window);

    /// `number` counts from 1.
    void showStep(int number, int count, const QString& title, const QString& text);
    /// Shows that the person has done it.
    void setDone(bool done);
    /// Places itself beside the ring, or rather below it, within the window; over what is in the ring only where there
    /// is no other room.
    void standBeside(const QRect& ring, bool rather_below);

    // For tests.
    QPushButton* next() const { return next_; }
    QPushButton* leave() const { return leave_; }

signals:
    void nextRequested();
    void leaveRequested();

protected:
    /// Return is Next, or Leave if that has the focus.
    void keyPressEvent(QKeyEvent* event) override;

private:
    QLabel* number_ = new QLabel(this);
    QLabel* title_ = new QLabel(this);
    QLabel* text_ = new QLabel(this);
    QLabel* tick_ = new QLabel(this);
    QPushButton* leave_ = new QPushButton(tr("Leave"), this);
    QPushButton* next_ = new QPushButton(this);
};

/// The place of a card of this size in the room, beside the ring; see TourCard::standBeside.
QRect placeBeside(const QRect& ring, const QSize& card, const QRect& room, bool rather_below);

} // namespace usar::widgets
