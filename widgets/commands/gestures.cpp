#include "widgets/commands/gestures.h"

#include <QObject>

namespace usar::widgets {

QList<std::pair<QString, QString>> gestures() {
    return {{QObject::tr("Double-click a start pose"), QObject::tr("Spawn a robot there")},
            {QObject::tr("Click a start pose"), QObject::tr("Choose class, name and behavior first")},
            {QObject::tr("Drag with the area tool"), QObject::tr("Draw the mission area; its handles change it")},
            {QObject::tr("Wheel"), QObject::tr("Zoom at the cursor")},
            {QObject::tr("Arrow keys, drag"), QObject::tr("Pan the map")},
            {QObject::tr("W S, A D, Q E, R F held while you drive"),
             QObject::tr("Forward and back, round, sideways, up and down; Shift slower, Space stops")},
            {QObject::tr("Drag the camera's picture, wheel on it"), QObject::tr("Turn the camera, zoom it")},
            {QObject::tr("Double-click a sensor value"), QObject::tr("Plot it")},
            {QObject::tr("Press an object in the palette, click on the map"), QObject::tr("Put it into the world")},
            {QObject::tr("Drag an object"), QObject::tr("Move it")}};
}

} // namespace usar::widgets
