<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Message</name>
    <message>
        <source>The CPU engine needs a processor with SSE4; draw with OpenGL on this one.</source>
        <translation>Die CPU-Engine braucht einen Prozessor mit SSE4; zeichnen Sie auf diesem mit OpenGL.</translation>
    </message>
    <message>
        <source>LIMN_CPU_TARGET is &quot;%1&quot;, which this processor does not have; unset it.</source>
        <translation>LIMN_CPU_TARGET ist „%1“, was dieser Prozessor nicht hat; löschen Sie die Variable.</translation>
    </message>
    <message>
        <source>LIMN_CPU_TARGET is &quot;%1&quot;; use one of %2, or unset it.</source>
        <translation>LIMN_CPU_TARGET ist „%1“; verwenden Sie eines von %2, oder löschen Sie die Variable.</translation>
    </message>
    <message>
        <source>names a value longer than the file</source>
        <translation>nennt einen Wert, der länger ist als die Datei</translation>
    </message>
    <message>
        <source>The run-length encoded pixels of %1 are damaged or cut off; copy the file again from its source.</source>
        <translation>Die lauflängenkodierten Pixel von %1 sind beschädigt oder abgeschnitten; kopieren Sie die Datei neu von ihrer Quelle.</translation>
    </message>
    <message>
        <source>its project list is too long</source>
        <translation>ihre Projektliste ist zu lang</translation>
    </message>
    <message>
        <source>its project list is damaged</source>
        <translation>ihre Projektliste ist beschädigt</translation>
    </message>
    <message>
        <source>it is an archive but no InVesalius 3 project (it has no main.plist)</source>
        <translation>sie ist ein Archiv, aber kein Projekt von InVesalius 3 (main.plist fehlt)</translation>
    </message>
    <message>
        <source>unpack it and open the volume inside</source>
        <translation>entpacken Sie sie, und öffnen Sie das Volumen darin</translation>
    </message>
    <message>
        <source>its other half %1%2 is missing</source>
        <translation>ihre andere Hälfte %1%2 fehlt</translation>
    </message>
    <message>
        <source>copy both files of the pair into one folder</source>
        <translation>kopieren Sie beide Dateien des Paars in einen Ordner</translation>
    </message>
    <message>
        <source>its header does not give 2 to 7 dimensions</source>
        <translation>ihr Header nennt nicht 2 bis 7 Dimensionen</translation>
    </message>
    <message>
        <source>its header gives more volumes than any file holds</source>
        <translation>ihr Header nennt mehr Volumen, als eine Datei enthält</translation>
    </message>
    <message>
        <source>it is a folder where a file is needed</source>
        <translation>sie ist ein Ordner, wo eine Datei gebraucht wird</translation>
    </message>
    <message>
        <source>choose a file</source>
        <translation>wählen Sie eine Datei</translation>
    </message>
    <message>
        <source>check the name and the right to read it</source>
        <translation>prüfen Sie den Namen und das Leserecht</translation>
    </message>
    <message>
        <source>its voxels are spread over several files</source>
        <translation>ihre Voxel sind auf mehrere Dateien verteilt</translation>
    </message>
    <message>
        <source>save it as one file</source>
        <translation>speichern Sie sie als eine Datei</translation>
    </message>
    <message>
        <source>it names its voxel file &quot;%1&quot;, which is not in the folder of the header</source>
        <translation>sie nennt ihre Voxeldatei „%1“, die nicht im Ordner des Headers liegt</translation>
    </message>
    <message>
        <source>put both files into one folder and name the voxel file without a path</source>
        <translation>legen Sie beide Dateien in einen Ordner, und nennen Sie die Voxeldatei ohne Pfad</translation>
    </message>
    <message>
        <source>its voxel file %1 is missing</source>
        <translation>ihre Voxeldatei %1 fehlt</translation>
    </message>
    <message>
        <source>copy that file beside the header</source>
        <translation>kopieren Sie diese Datei neben den Header</translation>
    </message>
    <message>
        <source>it names itself as its voxel file</source>
        <translation>sie nennt sich selbst als Voxeldatei</translation>
    </message>
    <message>
        <source>its voxel file &quot;%1&quot; is a link that leads out of the folder</source>
        <translation>ihre Voxeldatei „%1“ ist ein Verweis, der aus dem Ordner führt</translation>
    </message>
    <message>
        <source>replace the link by the file itself</source>
        <translation>ersetzen Sie den Verweis durch die Datei selbst</translation>
    </message>
    <message>
        <source>its header gives the dimensions %1 x %2 x %3</source>
        <translation>ihr Header nennt die Abmessungen %1 x %2 x %3</translation>
    </message>
    <message>
        <source>%1, which leave no voxels</source>
        <translation>%1, was keine Voxel übrig lässt</translation>
    </message>
    <message>
        <source>%1, which is too large for any computer</source>
        <translation>%1, was für jeden Rechner zu groß ist</translation>
    </message>
    <message>
        <source>if they are right, save a smaller part of the volume; otherwise export the file again</source>
        <translation>wenn sie stimmen, speichern Sie einen kleineren Teil des Volumens; sonst exportieren Sie die Datei neu</translation>
    </message>
    <message>
        <source>its header&apos;s line %1 has too few numbers</source>
        <translation>die Zeile %1 ihres Headers hat zu wenige Zahlen</translation>
    </message>
    <message>
        <source>it does not hold exactly one piece</source>
        <translation>sie enthält nicht genau ein Stück</translation>
    </message>
    <message>
        <source>save it as one piece</source>
        <translation>speichern Sie sie als ein Stück</translation>
    </message>
    <message>
        <source>its piece does not fill its extent</source>
        <translation>ihr Stück füllt seine Ausdehnung nicht</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>prüfen Sie den Pfad</translation>
    </message>
    <message>
        <source>it is far larger than any file of this kind</source>
        <translation>sie ist weit größer als jede Datei dieser Art</translation>
    </message>
    <message>
        <source>choose another file</source>
        <translation>wählen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>it cannot be opened</source>
        <translation>sie lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>check that you may read it</source>
        <translation>prüfen Sie, ob Sie sie lesen dürfen</translation>
    </message>
    <message>
        <source>open a DICOM folder, NIfTI, NRRD, MetaImage, VTI or VTK image, a stack of TIFF, PNG or JPEG pictures, or an InVesalius project</source>
        <translation>öffnen Sie einen DICOM-Ordner, ein NIfTI-, NRRD-, MetaImage-, VTI- oder VTK-Bild, einen Stapel aus TIFF-, PNG- oder JPEG-Bildern oder ein InVesalius-Projekt</translation>
    </message>
    <message>
        <source>The spacing must be three positive numbers of millimetres.</source>
        <translation>Der Voxelabstand muss aus drei positiven Zahlen in Millimetern bestehen.</translation>
    </message>
    <message>
        <source>Cannot open %1: it is no figure of Limn; choose a volume, a scene or a picture.</source>
        <translation>%1 kann nicht geöffnet werden: Die Datei ist keine Abbildung von Limn; wählen Sie ein Volumen, eine Szene oder ein Bild.</translation>
    </message>
    <message>
        <source>save the look again in the program that made it</source>
        <translation>speichern Sie die Darstellung in ihrem Programm neu</translation>
    </message>
    <message>
        <source>its entry &quot;%1&quot; is missing</source>
        <translation>ihr Eintrag „%1“ fehlt</translation>
    </message>
    <message>
        <source>it is a file of Voreen without a transfer function of values</source>
        <translation>sie ist eine Datei von Voreen ohne Transferfunktion über Werte</translation>
    </message>
    <message>
        <source>save a one-dimensional transfer function (.tfi) in Voreen</source>
        <translation>speichern Sie in Voreen eine eindimensionale Transferfunktion (.tfi)</translation>
    </message>
    <message>
        <source>must be a colour such as #ff8000</source>
        <translation>muss eine Farbe sein, wie #ff8000</translation>
    </message>
    <message>
        <source>So little memory is not enough for any volume; give at least %1 MB (--memory).</source>
        <translation>So wenig Speicher reicht für kein Volumen; mindestens %1&#xa0;MB angeben (--memory).</translation>
    </message>
    <message>
        <source>its voxels end early</source>
        <translation>ihre Voxel enden vorzeitig</translation>
    </message>
    <message>
        <source>it is damaged or cut off (near its character %1)</source>
        <translation>sie ist beschädigt oder abgeschnitten (nahe ihrem Zeichen %1)</translation>
    </message>
    <message>
        <source>it holds a number that is too large to be one</source>
        <translation>sie enthält eine Zahl, die zu groß ist, um eine zu sein</translation>
    </message>
    <message>
        <source>it is no picture that Limn saved with its look</source>
        <translation>es ist kein Bild, das Limn mit seiner Darstellung gespeichert hat</translation>
    </message>
    <message>
        <source>choose one that Limn saved of a volume, or a look</source>
        <translation>wählen Sie eines, das Limn von einem Volumen gespeichert hat, oder eine Darstellung</translation>
    </message>
    <message>
        <source>The labels %1 are not where they are expected (%2); put them there or beside the volume.</source>
        <translation>Die Labels %1 sind nicht dort, wo sie erwartet werden (%2); legen Sie sie dorthin oder neben das Volumen.</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Ziehen mit links</translation>
    </message>
    <message>
        <source>rotate, or what the chosen tool does</source>
        <translation>drehen oder was das gewählte Werkzeug tut</translation>
    </message>
    <message>
        <source>tools: rotate, pan, zoom, window and level</source>
        <translation>Werkzeuge: drehen, verschieben, zoomen, fenstern</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>cancel a drag; otherwise rotate again</source>
        <translation>Ziehen abbrechen; sonst wieder drehen</translation>
    </message>
    <message>
        <source>Middle drag, Shift+left drag</source>
        <translation>Ziehen mit Mitteltaste, Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>Right drag, + −</source>
        <translation>Ziehen mit rechts, + −</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>zoomen</translation>
    </message>
    <message>
        <source>Ctrl+left drag</source>
        <translation>Strg+Ziehen</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>rollen</translation>
    </message>
    <message>
        <source>Alt+left drag</source>
        <translation>Alt+Ziehen</translation>
    </message>
    <message>
        <source>window and level; with Ctrl: opacity</source>
        <translation>fenstern; mit Strg: Deckkraft</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>rotate</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>reset the camera</source>
        <translation>Kamera zurücksetzen</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>swap the two sides while held</source>
        <translation>die beiden Seiten vertauschen, solange gedrückt</translation>
    </message>
    <message>
        <source>B, drag a handle</source>
        <translation>B, Griff ziehen</translation>
    </message>
    <message>
        <source>crop box; double click a handle: that face uncut</source>
        <translation>Zuschnittbox; Doppelklick am Griff: Seite unbeschnitten</translation>
    </message>
    <message>
        <source>0, 1 … 9</source>
        <translation>0, 1 … 9</translation>
    </message>
    <message>
        <source>full range, presets</source>
        <translation>voller Wertebereich, Presets</translation>
    </message>
    <message>
        <source>F11, double click</source>
        <translation>F11, Doppelklick</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>crosshair, or what the chosen tool does</source>
        <translation>Fadenkreuz oder was das gewählte Werkzeug tut</translation>
    </message>
    <message>
        <source>Wheel, PgUp PgDn</source>
        <translation>Mausrad, Bild↑ Bild↓</translation>
    </message>
    <message>
        <source>through the slices; Shift+keys: ten at a time</source>
        <translation>durch die Schnitte; mit Umschalt je zehn</translation>
    </message>
    <message>
        <source>Right drag, Alt+left drag</source>
        <translation>Ziehen mit rechts, Alt+Ziehen</translation>
    </message>
    <message>
        <source>window and level</source>
        <translation>fenstern</translation>
    </message>
    <message>
        <source>0, 1 2 3 4</source>
        <translation>0, 1 2 3 4</translation>
    </message>
    <message>
        <source>full range; soft tissue, lung, bone, brain</source>
        <translation>voller Wertebereich; Weichteile, Lunge, Knochen, Gehirn</translation>
    </message>
    <message>
        <source>Ctrl+wheel, + −, F</source>
        <translation>Strg+Mausrad, + −, F</translation>
    </message>
    <message>
        <source>zoom, show all of the slice</source>
        <translation>zoomen, ganzen Schnitt zeigen</translation>
    </message>
    <message>
        <source>Arrows, Home</source>
        <translation>Pfeiltasten, Pos1</translation>
    </message>
    <message>
        <source>move the crosshair; to the middle</source>
        <translation>Fadenkreuz bewegen; in die Mitte</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>one slice large, and back</source>
        <translation>ein Schnitt groß und zurück</translation>
    </message>
    <message>
        <source>Shift+click the picture</source>
        <translation>Umschalt+Klick ins Bild</translation>
    </message>
    <message>
        <source>the crosshair goes to that place</source>
        <translation>das Fadenkreuz springt dorthin</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Click the curve, double click</source>
        <translation>Klick auf die Kurve, Doppelklick</translation>
    </message>
    <message>
        <source>add a point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Drag a point</source>
        <translation>Punkt ziehen</translation>
    </message>
    <message>
        <source>move; Shift locks an axis, Alt moves finely</source>
        <translation>bewegen; Umschalt hält eine Achse fest, Alt bewegt fein</translation>
    </message>
    <message>
        <source>Middle click, Del</source>
        <translation>Mittelklick, Entf</translation>
    </message>
    <message>
        <source>delete</source>
        <translation>löschen</translation>
    </message>
    <message>
        <source>Double click a point</source>
        <translation>Doppelklick auf einen Punkt</translation>
    </message>
    <message>
        <source>Drag the handle</source>
        <translation>Griff ziehen</translation>
    </message>
    <message>
        <source>shift the curve; Alt: width</source>
        <translation>Kurve verschieben; Alt: Breite</translation>
    </message>
    <message>
        <source>Wheel, Shift+wheel</source>
        <translation>Mausrad, Umschalt+Mausrad</translation>
    </message>
    <message>
        <source>zoom, pan the value axis</source>
        <translation>Werteachse zoomen, verschieben</translation>
    </message>
    <message>
        <source>Tab, arrows, Enter</source>
        <translation>Tab, Pfeiltasten, Eingabe</translation>
    </message>
    <message>
        <source>walk the points, move, type numbers</source>
        <translation>Punkte durchgehen, bewegen, Zahlen eintippen</translation>
    </message>
    <message>
        <source>N, Ins</source>
        <translation>N, Einfg</translation>
    </message>
    <message>
        <source>add a point beside the one in hand</source>
        <translation>Punkt neben dem gewählten hinzufügen</translation>
    </message>
    <message>
        <source>Menu key</source>
        <translation>Menütaste</translation>
    </message>
    <message>
        <source>colour and numbers, delete, show all values</source>
        <translation>Farbe und Zahlen, löschen, alle Werte zeigen</translation>
    </message>
    <message>
        <source>Ctrl with + − 0 ← →</source>
        <translation>Strg mit + − 0 ← →</translation>
    </message>
    <message>
        <source>zoom the value axis, show all of it, pan</source>
        <translation>Werteachse zoomen, ganz zeigen, verschieben</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>About Limn</source>
        <translation>Über Limn</translation>
    </message>
    <message>
        <source>Sample head</source>
        <translation>Beispielkopf</translation>
    </message>
    <message>
        <source>Limn · not for diagnosis</source>
        <translation>Limn · nicht zur Diagnose</translation>
    </message>
    <message>
        <source>%1×%2×%3 · %4×%5×%6 mm · %7 to %8 %9</source>
        <translation>%1×%2×%3 · %4×%5×%6&#xa0;mm · %7 bis %8 %9</translation>
    </message>
    <message>
        <source>%L1 voxels hold no data and are shown as the smallest value.</source>
        <translation>%L1 Voxel enthalten keine Daten und werden als kleinster Wert gezeigt.</translation>
    </message>
    <message>
        <source>Replace the file?</source>
        <translation>Datei ersetzen?</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 ist schon vorhanden. Ersetzen?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Surface at %1</source>
        <translation>Oberfläche bei %1</translation>
    </message>
    <message>
        <source>Skin and airways</source>
        <translation>Haut und Atemwege</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <comment>two tissues</comment>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>Within %1</source>
        <comment>a tissue</comment>
        <translation>Innerhalb: %1</translation>
    </message>
    <message>
        <source>%1, between %2 and %3; %4 % of all boundaries</source>
        <translation>%1, zwischen %2 und %3; %4&#xa0;% aller Grenzflächen</translation>
    </message>
    <message>
        <source>%1 at cursor · %2 mm</source>
        <translation>%1 am Zeiger · %2&#xa0;mm</translation>
    </message>
    <message>
        <source>step 1/%1 voxel</source>
        <translation>Schrittweite 1/%1 Voxel</translation>
    </message>
    <message>
        <source>step 1 voxel</source>
        <translation>Schrittweite 1 Voxel</translation>
    </message>
    <message>
        <source>step %1 voxels</source>
        <translation>Schrittweite %1 Voxel</translation>
    </message>
    <message>
        <source>exact to half a level</source>
        <translation>auf eine halbe Stufe genau</translation>
    </message>
    <message>
        <source>exact to %1 levels</source>
        <translation>auf %1 Stufen genau</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>&lt; %1 levels</source>
        <translation>&lt; %1 Stufen</translation>
    </message>
    <message>
        <source>%1 levels</source>
        <translation>%1 Stufen</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>less than %1 levels</source>
        <translation>weniger als %1 Stufen</translation>
    </message>
    <message>
        <source>1 level</source>
        <translation>1 Stufe</translation>
    </message>
    <message>
        <source>, curve averaged</source>
        <translation>, Kurve gemittelt</translation>
    </message>
    <message>
        <source>steps by error</source>
        <translation>fehlergesteuerte Schritte</translation>
    </message>
    <message>
        <source>equal steps</source>
        <translation>gleiche Schritte</translation>
    </message>
    <message>
        <source>%1, curve averaged</source>
        <translation>%1, Kurve gemittelt</translation>
    </message>
    <message>
        <source>%1: not converged, so the error is unknown; %2.</source>
        <translation>%1: nicht konvergiert, deshalb ist der Fehler unbekannt; %2.</translation>
    </message>
    <message>
        <source>%1: within %2, %3.</source>
        <translation>%1: Fehler %2, %3.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>%1 voxels = %2 mm</source>
        <translation>%1 Voxel = %2&#xa0;mm</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>Größter Fehler</translation>
    </message>
    <message>
        <source>99.9th percentile</source>
        <translation>99,9. Perzentil</translation>
    </message>
    <message>
        <source>Mean error</source>
        <translation>Mittlerer Fehler</translation>
    </message>
    <message>
        <source>Off by over 1 level</source>
        <translation>Um mehr als 1 Stufe falsch</translation>
    </message>
    <message>
        <source>%1 % of pixels</source>
        <translation>%1&#xa0;% der Pixel</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>%1 (%2 – %3)</source>
        <translation>%1 (%2 – %3)</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1&lt;/p&gt;&lt;p&gt;Range %2%3, default %4%3. Double click on the name to reset.&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1&lt;/p&gt;&lt;p&gt;Bereich %2%3, Standard %4%3. Doppelklick auf den Namen setzt zurück.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>In %1. %2</source>
        <translation>In %1. %2</translation>
    </message>
    <message>
        <source>change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>add point at %1</source>
        <translation>Punkt bei %1 hinzufügen</translation>
    </message>
    <message>
        <source>shift curve by %1</source>
        <translation>Kurve um %1 verschieben</translation>
    </message>
    <message>
        <source>change width of curve</source>
        <translation>Breite der Kurve ändern</translation>
    </message>
    <message>
        <source>delete %1 points</source>
        <translation>%1 Punkte löschen</translation>
    </message>
    <message>
        <source>delete point at %1</source>
        <translation>Punkt bei %1 löschen</translation>
    </message>
    <message>
        <source>move %1 points</source>
        <translation>%1 Punkte bewegen</translation>
    </message>
    <message>
        <source>move point to %1</source>
        <translation>Punkt nach %1 bewegen</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>gradient</source>
        <translation>Gradient</translation>
    </message>
    <message>
        <source>pinned: %1</source>
        <translation>angeheftet: %1</translation>
    </message>
    <message>
        <source> · opacity %1</source>
        <translation> · Deckkraft %1</translation>
    </message>
    <message>
        <source>Crosshair outside the volume</source>
        <translation>Fadenkreuz außerhalb des Volumens</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1&#xa0;mm</translation>
    </message>
    <message>
        <source>Orientation unknown</source>
        <translation>Orientierung unbekannt</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Columns × rows</source>
        <translation>Spalten × Zeilen</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Columns × slices</source>
        <translation>Spalten × Schichten</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Rows × slices</source>
        <translation>Zeilen × Schichten</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>W %1 · L %2</source>
        <translation>W %1 · L %2</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>Mittel %1</translation>
    </message>
    <message>
        <source>max %1</source>
        <translation>Max. %1</translation>
    </message>
    <message>
        <source>Modified. %1</source>
        <comment>a preset; its note follows</comment>
        <translation>Verändert. %1</translation>
    </message>
    <message>
        <source>PET</source>
        <translation>PET</translation>
    </message>
    <message>
        <source>Ultrasound</source>
        <translation>Ultraschall</translation>
    </message>
    <message>
        <source>Any data</source>
        <translation>Beliebige Daten</translation>
    </message>
    <message>
        <source>My presets</source>
        <translation>Eigene Presets</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Füße</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>first</source>
        <translation>erste</translation>
    </message>
    <message>
        <source>last</source>
        <translation>letzte</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Unlit</source>
        <translation>Unbeleuchtet</translation>
    </message>
    <message>
        <source>Classic</source>
        <translation>Klassisch</translation>
    </message>
    <message>
        <source>Enhanced</source>
        <translation>Verstärkt</translation>
    </message>
    <message>
        <source>Robust</source>
        <translation>Robust</translation>
    </message>
    <message>
        <source>move crop face: %1</source>
        <translation>Zuschnittfläche bewegen: %1</translation>
    </message>
    <message>
        <source>change opacity</source>
        <translation>Deckkraft ändern</translation>
    </message>
    <message>
        <source>change window and level</source>
        <translation>Fensterung ändern</translation>
    </message>
    <message>
        <source>%1: %2 % cut</source>
        <translation>%1: %2&#xa0;% abgeschnitten</translation>
    </message>
    <message>
        <source> · %1 mm</source>
        <translation> · %1&#xa0;mm</translation>
    </message>
    <message>
        <source>+%1 of 255</source>
        <translation>+%1 von 255</translation>
    </message>
    <message>
        <source>%1 brighter</source>
        <translation>%1 heller</translation>
    </message>
    <message>
        <source>Not for diagnosis</source>
        <translation>Nicht zur Diagnose</translation>
    </message>
    <message>
        <source>1 label hidden or faded</source>
        <translation>1 Label ausgeblendet oder abgeschwächt</translation>
    </message>
    <message>
        <source>%1 labels hidden or faded</source>
        <translation>%1 Labels ausgeblendet oder abgeschwächt</translation>
    </message>
    <message>
        <source>SP %1</source>
        <translation>SP %1</translation>
    </message>
    <message>
        <source>SP %1 · O %2</source>
        <translation>SP %1 · O %2</translation>
    </message>
    <message>
        <source>within %1 levels</source>
        <translation>auf %1 Stufen genau</translation>
    </message>
    <message>
        <source>unlit, the same with every model</source>
        <translation>unbeleuchtet, bei jedem Modell gleich</translation>
    </message>
    <message>
        <source>%2 minus %1, ×%3</source>
        <translation>%2 minus %1, ×%3</translation>
    </message>
    <message>
        <source>Black where both are equal, brighter the more they differ</source>
        <translation>Schwarz, wo beide gleich sind; heller, je mehr sie sich unterscheiden</translation>
    </message>
    <message>
        <source>&lt;p&gt;Black where both sides show the same; blue where the left side is brighter, orange where the right side is, by the part of the colour that differs most. Differences are shown %1 times as large as they are.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Schwarz, wo beide Seiten das Gleiche zeigen; blau, wo die linke Seite heller ist, orange, wo die rechte heller ist, gemessen am Farbanteil mit dem größten Unterschied. Unterschiede werden %1-fach vergrößert gezeigt.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>%1 (right)</source>
        <translation>%1 (rechts)</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1&#xa0;s</translation>
    </message>
    <message>
        <source>estimated within about %1 of 255 levels</source>
        <translation>Fehler geschätzt höchstens etwa %1 von 255 Stufen</translation>
    </message>
    <message>
        <source>estimated within %1 of 255 levels</source>
        <translation>Fehler geschätzt höchstens %1 von 255 Stufen</translation>
    </message>
    <message>
        <source>99.9 % of pixels within %1 of 255 levels (95 % sure)</source>
        <translation>99,9&#xa0;% der Bildpunkte höchstens %1 von 255 Stufen falsch (zu 95&#xa0;% sicher)</translation>
    </message>
    <message>
        <source>Black and white are 255 levels apart.</source>
        <translation>Schwarz und Weiß liegen 255 Stufen auseinander.</translation>
    </message>
    <message>
        <source>not resolved</source>
        <translation>nicht aufgelöst</translation>
    </message>
    <message>
        <source>estimating…</source>
        <translation>wird geschätzt…</translation>
    </message>
    <message>
        <source>left %1</source>
        <translation>links %1</translation>
    </message>
    <message>
        <source>right %1</source>
        <translation>rechts %1</translation>
    </message>
    <message>
        <source>○ preview</source>
        <translation>○ Vorschau</translation>
    </message>
    <message>
        <source>● exact to the screen</source>
        <translation>● exakt für den Bildschirm</translation>
    </message>
    <message>
        <source>◐ refining</source>
        <translation>◐ wird verfeinert</translation>
    </message>
    <message>
        <source>○ not exact</source>
        <translation>○ nicht exakt</translation>
    </message>
    <message>
        <source>○ not resolved</source>
        <translation>○ nicht aufgelöst</translation>
    </message>
    <message>
        <source>preview, step %1</source>
        <translation>Vorschau, Schritt %1</translation>
    </message>
    <message>
        <source>preview at %1 resolution</source>
        <translation>Vorschau mit %1 Auflösung</translation>
    </message>
    <message>
        <source>refined, step %1</source>
        <translation>verfeinert, Schritt %1</translation>
    </message>
    <message>
        <source>smallest step, %1</source>
        <translation>kleinste Schrittweite, %1</translation>
    </message>
    <message>
        <source>No smaller step is drawn: it would take long and show little.</source>
        <translation>Kleinere Schritte werden nicht gezeichnet: Das würde lange dauern und wenig zeigen.</translation>
    </message>
    <message>
        <source>smallest possible step, %1</source>
        <translation>kleinste mögliche Schrittweite, %1</translation>
    </message>
    <message>
        <source>With a smaller step rays would need more samples than the driver allows.</source>
        <translation>Mit kleineren Schritten bräuchten Strahlen mehr Abtastpunkte, als der Treiber zulässt.</translation>
    </message>
    <message>
        <source>smallest practical step, %1</source>
        <translation>kleinste praktikable Schrittweite, %1</translation>
    </message>
    <message>
        <source>The next smaller step would take too long on this machine.</source>
        <translation>Die nächstkleinere Schrittweite würde auf diesem Rechner zu lange dauern.</translation>
    </message>
    <message>
        <source>step %1, not refined</source>
        <translation>Schritt %1, nicht verfeinert</translation>
    </message>
    <message>
        <source>Refining the picture failed.</source>
        <translation>Das Bild konnte nicht verfeinert werden.</translation>
    </message>
    <message>
        <source>step %1, refining</source>
        <translation>Schritt %1, wird verfeinert</translation>
    </message>
    <message>
        <source>The picture is being drawn again with smaller steps.</source>
        <translation>Das Bild wird mit kleineren Schritten neu gezeichnet.</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>chosen by error</source>
        <translation>nach dem Fehler gewählt</translation>
    </message>
    <message>
        <source>Not resolved: a band of the curve is narrower than what the value changes by within one step, so the picture may miss it and no number would be right. Pre-integrated steps, or smaller ones, see it.</source>
        <translation>Nicht aufgelöst: Ein Band der Kurve ist schmaler als die Änderung des Werts innerhalb eines Schritts; das Bild kann es verfehlen, und keine Zahl wäre richtig. Vorintegrierte oder kleinere Schritte erfassen es.</translation>
    </message>
    <message>
        <source>How far the picture lies from the exact one is being estimated.</source>
        <translation>Es wird geschätzt, wie weit das Bild vom exakten entfernt ist.</translation>
    </message>
    <message>
        <source>999 of 1000 colour values of a smaller picture of the same scene were measured to lie within %1 levels of the exact one; black and white are 255 levels apart.</source>
        <translation>999 von 1000 Farbwerten eines kleineren Bildes derselben Szene liegen nach Messung höchstens %1 Stufen neben dem exakten; Schwarz und Weiß liegen 255 Stufen auseinander.</translation>
    </message>
    <message>
        <source>999 of 1000 colour values of the picture are estimated to lie within %1 levels of the exact picture; black and white are 255 levels apart.</source>
        <translation>999 von 1000 Farbwerten des Bildes liegen nach Schätzung höchstens %1 Stufen neben dem exakten Bild; Schwarz und Weiß liegen 255 Stufen auseinander.</translation>
    </message>
    <message>
        <source>Estimated from a smaller picture.</source>
        <translation>Geschätzt an einem kleineren Bild.</translation>
    </message>
    <message>
        <source>The preview also has fewer pixels than the window; that comes on top.</source>
        <translation>Die Vorschau hat außerdem weniger Pixel als das Fenster; das kommt hinzu.</translation>
    </message>
    <message>
        <source>99.9th percentile %1, mean %2 levels</source>
        <translation>99,9. Perzentil %1, Mittelwert %2 Stufen</translation>
    </message>
    <message>
        <source>%1, observed order %2</source>
        <translation>%1, beobachtete Ordnung %2</translation>
    </message>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>processor</source>
        <translation>Prozessor</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 Voxel</translation>
    </message>
    <message>
        <source>%1 voxel</source>
        <translation>%1 Voxel</translation>
    </message>
    <message>
        <source>This computer offers the program no OpenGL 3.0, so the processor draws; to have the graphics card draw, install or update its driver.</source>
        <translation>Dieser Rechner bietet dem Programm kein OpenGL 3.0, deshalb zeichnet der Prozessor; damit die Grafikkarte zeichnet, installieren oder aktualisieren Sie deren Treiber.</translation>
    </message>
    <message>
        <source>Shift+move</source>
        <translation>Umschalt+Bewegen</translation>
    </message>
    <message>
        <source>value under the pointer; View ▸ Ray: along the ray below it</source>
        <translation>Wert unter dem Zeiger; Ansicht ▸ Strahl: entlang des Strahls</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Umschalt+Klick</translation>
    </message>
    <message>
        <source>keep that value: buttons make its tissue more or less opaque</source>
        <translation>Wert anheften; sein Gewebe mehr oder weniger deckend</translation>
    </message>
    <message>
        <source>look from front, left, above; Shift: the opposite</source>
        <translation>Blick von vorn, links, oben; mit Umschalt von gegenüber</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>F6, Shift+F6</source>
        <translation>F6, Umschalt+F6</translation>
    </message>
    <message>
        <source>the keyboard goes to the next panel, the one before</source>
        <translation>Tastatur zum nächsten Bereich, zum vorherigen</translation>
    </message>
    <message>
        <source>Ctrl+F</source>
        <translation>Strg+F</translation>
    </message>
    <message>
        <source>find a preset; Enter uses it and goes on to the picture</source>
        <translation>Preset suchen; Eingabe verwendet es und geht zum Bild</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Presets</translation>
    </message>
    <message>
        <source>Point at one, arrows</source>
        <translation>Auf eines zeigen, Pfeiltasten</translation>
    </message>
    <message>
        <source>see it for a while; a click or Enter uses it</source>
        <translation>vorübergehend ansehen; Klick oder Eingabe verwendet es</translation>
    </message>
    <message>
        <source>F, F2, Del</source>
        <translation>F, F2, Entf</translation>
    </message>
    <message>
        <source>favourite; rename, delete one of your own</source>
        <translation>Favorit; ein eigenes umbenennen, löschen</translation>
    </message>
    <message>
        <source>Ctrl+B, Ctrl+Shift+B</source>
        <translation>Strg+B, Strg+Umschalt+B</translation>
    </message>
    <message>
        <source>remember a look, compare it with now</source>
        <translation>Darstellung merken, mit der jetzigen vergleichen</translation>
    </message>
    <message>
        <source>the crosshair again</source>
        <translation>wieder Fadenkreuz</translation>
    </message>
    <message>
        <source>Rest on a point, H</source>
        <translation>Auf einem Punkt verweilen, H</translation>
    </message>
    <message>
        <source>what it governs lights up in slices and picture</source>
        <translation>was er bestimmt, leuchtet in Schnitten und Bild auf</translation>
    </message>
    <message>
        <source>Menus</source>
        <translation>Menüs</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Limn %1&lt;/h3&gt;&lt;p&gt;Shows CT and MR volumes in three dimensions: you shape which tissue is seen, in which colour and how solid, and compare ways of lighting it side by side.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Not for diagnosis.&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Limn %1&lt;/h3&gt;&lt;p&gt;Zeigt CT- und MR-Volumen dreidimensional: Sie bestimmen, welches Gewebe zu sehen ist, in welcher Farbe und wie deckend, und vergleichen Arten der Beleuchtung nebeneinander.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Nicht zur Diagnose.&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder neuer.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Panel %1 shows nothing: everything in view is transparent.</source>
        <translation>Teilbild %1 zeigt nichts: Alles im Blickfeld ist durchsichtig.</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1&#xa0;GB</translation>
    </message>
    <message>
        <source>The figure has %1 × %2 pixels and takes %3 of memory while it is made</source>
        <translation>Die Abbildung hat %1 × %2 Pixel und braucht beim Erstellen %3 Speicher</translation>
    </message>
    <message>
        <source>%1; %2 are free.</source>
        <translation>%1; frei sind %2.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>Picture: %1</source>
        <translation>Bild: %1</translation>
    </message>
    <message>
        <source>Slice: %1</source>
        <translation>Schnitt: %1</translation>
    </message>
    <message>
        <source>Preset: %1</source>
        <translation>Preset: %1</translation>
    </message>
    <message>
        <source>Save in:</source>
        <translation>Speichern in:</translation>
    </message>
    <message>
        <source>Look in:</source>
        <translation>Suchen in:</translation>
    </message>
    <message>
        <source>Folder:</source>
        <translation>Ordner:</translation>
    </message>
    <message>
        <source>at the crosshair: %1</source>
        <translation>am Fadenkreuz: %1</translation>
    </message>
    <message>
        <source>The figure would be %1 pixels %2; from %3 to %4 are possible: choose another size or fewer dots per inch.</source>
        <translation>Die Abbildung wäre %1 Pixel %2; möglich sind %3 bis %4: Wählen Sie eine andere Größe oder eine kleinere Auflösung.</translation>
    </message>
    <message>
        <source>wide</source>
        <translation>breit</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>What stands around the pictures leaves no room for them; choose a larger figure, smaller text or fewer marks.</source>
        <translation>Die Angaben um die Bilder lassen diesen keinen Platz; wählen Sie eine größere Abbildung, kleineren Text oder weniger Angaben.</translation>
    </message>
    <message>
        <source>99.9 % of pixels within %1 of 255 levels of the exact picture (95 % sure).</source>
        <translation>99,9&#xa0;% der Bildpunkte weichen höchstens um %1 von 255 Stufen vom exakten Bild ab (zu 95&#xa0;% sicher).</translation>
    </message>
    <message>
        <source>Estimated within %1 of 255 levels of the exact picture.</source>
        <translation>Fehler gegenüber dem exakten Bild nach Schätzung höchstens %1 von 255 Stufen.</translation>
    </message>
    <message>
        <source>%1 (%2).</source>
        <translation>%1 (%2).</translation>
    </message>
    <message>
        <source>Not for diagnosis.</source>
        <translation>Nicht zur Diagnose.</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>µm</source>
        <translation>µm</translation>
    </message>
    <message>
        <source>Shows nothing of this volume. %1</source>
        <comment>a preset; its note follows</comment>
        <translation>Zeigt nichts von diesem Volumen. %1</translation>
    </message>
    <message>
        <source>Move to folder</source>
        <translation>In Ordner verschieben</translation>
    </message>
    <message>
        <source>New folder…</source>
        <translation>Neuer Ordner…</translation>
    </message>
    <message>
        <source>Reset to this preset</source>
        <translation>Auf dieses Preset zurücksetzen</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>Compare with the picture</source>
        <translation>Mit dem Bild vergleichen</translation>
    </message>
    <message>
        <source>Remove from favourites</source>
        <translation>Aus Favoriten entfernen</translation>
    </message>
    <message>
        <source>Add to favourites</source>
        <translation>Zu Favoriten hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate…</source>
        <translation>Duplizieren…</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Note…</source>
        <translation>Notiz bearbeiten…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Copy name</source>
        <translation>Namen kopieren</translation>
    </message>
    <message>
        <source>favourite</source>
        <comment>a preset</comment>
        <translation>Favorit</translation>
    </message>
    <message>
        <source>shown</source>
        <comment>a preset</comment>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>modified</source>
        <comment>a preset</comment>
        <translation>verändert</translation>
    </message>
    <message>
        <source>shows nothing of this volume</source>
        <translation>zeigt nichts von diesem Volumen</translation>
    </message>
    <message>
        <source>%1, for Hounsfield units</source>
        <translation>%1, für Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>Favoriten</translation>
    </message>
    <message>
        <source>deep</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>%1 deep</source>
        <translation>Tiefe in %1</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>per unit of length</source>
        <translation>je Längeneinheit</translation>
    </message>
    <message>
        <source>per mm</source>
        <translation>je mm</translation>
    </message>
    <message>
        <source>Nothing shows along this ray: the picture gives no opacity to its values, %1 to %2.</source>
        <translation>Entlang dieses Strahls ist nichts zu sehen: Das Bild gibt seinen Werten, %1 bis %2, keine Deckkraft.</translation>
    </message>
    <message>
        <source>The pixel is %1 opaque.</source>
        <translation>Das Pixel ist zu %1 deckend.</translation>
    </message>
    <message>
        <source>An average: every depth counts alike, and none stands for the picture.</source>
        <translation>Ein Mittelwert: Jede Tiefe zählt gleich, und keine steht für das Bild.</translation>
    </message>
    <message>
        <source>The largest value, %1, lies %2 deep; the picture shows it alone.</source>
        <translation>Der größte Wert, %1, liegt in %2 Tiefe; das Bild zeigt nur ihn.</translation>
    </message>
    <message>
        <source>The smallest value, %1, lies %2 deep; the picture shows it alone.</source>
        <translation>Der kleinste Wert, %1, liegt in %2 Tiefe; das Bild zeigt nur ihn.</translation>
    </message>
    <message>
        <source>The surface lies %1 deep; the picture shows it alone.</source>
        <translation>Die Oberfläche liegt in %1 Tiefe; das Bild zeigt nur sie.</translation>
    </message>
    <message>
        <source>Half of the absorption lies within the first %1, up to %2.</source>
        <translation>Die Hälfte der Absorption ist nach %1 erreicht, beim Wert %2.</translation>
    </message>
    <message>
        <source>Half of the light comes from the first %1 of the volume, up to %2.</source>
        <translation>Die Hälfte des Lichts stammt aus den ersten %1 des Volumens, bis zum Wert %2.</translation>
    </message>
    <message>
        <source>%1, opacity %2 %3, %4 of the light so far</source>
        <translation>%1, Deckkraft %2 %3, bis hierher %4 des Lichts</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Opacity of the value</source>
        <translation>Deckkraft des Werts</translation>
    </message>
    <message>
        <source>What the picture takes</source>
        <translation>Was ins Bild eingeht</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Opacity %1</source>
        <translation>Deckkraft %1</translation>
    </message>
    <message>
        <source>Share of the pixel %1</source>
        <translation>Anteil am Pixel %1</translation>
    </message>
    <message>
        <source>Preview: %1</source>
        <translation>Vorschau: %1</translation>
    </message>
    <message>
        <source>Body only: table hidden</source>
        <translation>Nur Körper: Tisch ausgeblendet</translation>
    </message>
    <message>
        <source>Compared: %1</source>
        <translation>Verglichen: %1</translation>
    </message>
    <message>
        <source>Remembered: %1</source>
        <translation>Gemerkt: %1</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>small</source>
        <comment>labels within a sentence</comment>
        <extracomment>Not shown. Translate it as &quot;capital&quot; where nouns within a sentence have one.</extracomment>
        <translation>capital</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Strg+L</translation>
    </message>
    <message>
        <source>the look of the volume that was open before</source>
        <translation>Darstellung des zuvor geöffneten Volumens</translation>
    </message>
    <message>
        <source>Looks of Limn and other programs (%1)</source>
        <translation>Darstellungen von Limn und anderen Programmen (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>not imported</source>
        <translation>nicht importiert</translation>
    </message>
    <message>
        <source>imported as %1</source>
        <translation>importiert als %1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>There is another preset &quot;%1&quot; already, so that this one is called &quot;%2&quot;.</source>
        <translation>Es gibt schon ein anderes Preset „%1“; dieses heißt deshalb „%2“.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>%1 million</source>
        <translation>%1&#xa0;Millionen</translation>
    </message>
    <message>
        <source>The isosurface that the picture shows.</source>
        <translation>Die Isofläche, die das Bild zeigt.</translation>
    </message>
    <message>
        <source>The value that is pinned on the curve.</source>
        <translation>Der Wert, der auf der Kurve angeheftet ist.</translation>
    </message>
    <message>
        <source>The value of the selected point of the curve.</source>
        <translation>Der Wert des gewählten Punkts der Kurve.</translation>
    </message>
    <message>
        <source>Pin a value with a Shift+click in the picture to begin with that.</source>
        <translation>Heften Sie mit Umschalt+Klick im Bild einen Wert an, um mit ihm zu beginnen.</translation>
    </message>
    <message>
        <source>About %1 triangles, %2 MB as STL; making it takes %3 MB of memory.</source>
        <translation>Etwa %1 Dreiecke, %2&#xa0;MB als STL; die Berechnung braucht %3&#xa0;MB Speicher.</translation>
    </message>
    <message>
        <source>Those that the distance allows are taken away.</source>
        <translation>Wie viele davon wegfallen, bestimmt der Abstand.</translation>
    </message>
    <message>
        <source>Millimetres in the patient&apos;s axes: x to the left, y to the back, z to the head (LPS).</source>
        <translation>Millimeter in den Achsen des Patienten: x nach links, y nach hinten, z zum Kopf (LPS).</translation>
    </message>
    <message>
        <source>Saved %1: %2 triangles.</source>
        <translation>%1 gespeichert: %2 Dreiecke.</translation>
    </message>
    <message>
        <source>It is watertight: every edge is used twice.</source>
        <translation>Die Oberfläche ist wasserdicht: Jede Kante gehört zu zwei Dreiecken.</translation>
    </message>
    <message>
        <source>It is open: %1 edges lie at the rims of holes.</source>
        <translation>Die Oberfläche ist offen: %1 Kanten liegen am Rand von Löchern.</translation>
    </message>
    <message>
        <source>It lies at most %1 mm from the isosurface (%2 mm in the mean), measured at %3 points each way.</source>
        <translation>Sie liegt höchstens %1&#xa0;mm von der Isofläche entfernt (im Mittel %2&#xa0;mm), gemessen an je %3 Punkten in beiden Richtungen.</translation>
    </message>
    <message>
        <source>That is more than the %1 mm asked for, because the cells are too coarse in places; choose more detail.</source>
        <translation>Das ist mehr als die gewünschten %1&#xa0;mm, weil die Zellen stellenweise zu grob sind; wählen Sie mehr Details.</translation>
    </message>
    <message>
        <source>Small parts left out: %1; small hollows filled: %2.</source>
        <translation>Kleine Teile weggelassen: %1; kleine Hohlräume gefüllt: %2.</translation>
    </message>
    <message>
        <source>under the pointer: %1</source>
        <translation>unter dem Zeiger: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The volume does not lie in memory: while something moves the picture is drawn from 1/%1 of the voxels along each axis, whose values differ by at most %2 % of the range; at rest from all of them.</source>
        <translation>Das Volumen liegt nicht im Speicher: Solange sich etwas bewegt, wird das Bild aus 1/%1 der Voxel entlang jeder Achse gezeichnet, deren Werte um höchstens %2&#xa0;% des Wertebereichs abweichen; in Ruhe aus allen.</translation>
    </message>
    <message>
        <source>○ preview, voxels %1× coarser</source>
        <translation>○ Vorschau, Voxel %1× gröber</translation>
    </message>
    <message>
        <source>preview from 1/%1 of the voxels along each axis</source>
        <translation>Vorschau aus 1/%1 der Voxel entlang jeder Achse</translation>
    </message>
    <message>
        <source>%1 · on the disk</source>
        <translation>%1 · auf der Festplatte</translation>
    </message>
    <message>
        <source>&lt;p&gt;The voxels stay on the disk, because they would take more than a third of the memory that Limn may use (--memory). The processor draws them, and reads what the curve shows.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Die Voxel bleiben auf der Festplatte, weil sie mehr als ein Drittel des Speichers bräuchten, den Limn verwenden darf (--memory). Der Prozessor zeichnet sie und liest, was die Kurve zeigt.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Cropped</source>
        <translation>Zugeschnitten</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Reset crop</source>
        <translation>Zuschnitt zurücksetzen</translation>
    </message>
    <message>
        <source>The crop box cuts a part of the volume off. A click shows all of it again; B shows the box.</source>
        <translation>Die Zuschnittbox schneidet einen Teil des Volumens ab. Ein Klick zeigt wieder alles davon; B zeigt die Box.</translation>
    </message>
    <message>
        <source>A part of the volume is hidden. A click shows everything again; View ▸ Body only hides the table and what else lies beside the body.</source>
        <translation>Ein Teil des Volumens ist ausgeblendet. Ein Klick zeigt wieder alles; „Ansicht ▸ Nur Körper“ blendet den Tisch aus und was sonst neben dem Körper liegt.</translation>
    </message>
    <message>
        <source>%1 · outside the crop</source>
        <translation>%1 · außerhalb des Zuschnitts</translation>
    </message>
    <message>
        <source>The line is around what is kept</source>
        <translation>Die Linie umgibt, was erhalten bleibt</translation>
    </message>
    <message>
        <source>best trade-offs</source>
        <translation>beste Kompromisse</translation>
    </message>
    <message>
        <source>Time per picture, ms</source>
        <translation>Zeit je Bild, ms</translation>
    </message>
    <message>
        <source>Error, levels of 255 (mean)</source>
        <translation>Fehler, Stufen von 255 (Mittel)</translation>
    </message>
    <message>
        <source>Error, levels of 255 (99.9th percentile)</source>
        <translation>Fehler, Stufen von 255 (99,9. Perzentil)</translation>
    </message>
    <message>
        <source>%1 · %2 × %3 pixels · %4</source>
        <translation>%1 · %2 × %3 Pixel · %4</translation>
    </message>
    <message>
        <source>Nothing is measured yet.</source>
        <translation>Noch ist nichts gemessen.</translation>
    </message>
    <message>
        <source>Not converged: the exact picture still changes with finer steps, so no error is known.</source>
        <translation>Nicht konvergiert: Das exakte Bild ändert sich mit feineren Schritten noch, deshalb ist kein Fehler bekannt.</translation>
    </message>
    <message>
        <source>1 level: accurate to the screen</source>
        <translation>1 Stufe: genau für den Bildschirm</translation>
    </message>
    <message>
        <source>&lt; %1</source>
        <translation>&lt; %1</translation>
    </message>
    <message>
        <source>Shift+middle click</source>
        <translation>Umschalt+Mittelklick</translation>
    </message>
    <message>
        <source>turn about what is seen there, until R</source>
        <translation>um das drehen, was dort zu sehen ist, bis R</translation>
    </message>
    <message>
        <source>Right click, Menu key</source>
        <translation>Rechtsklick, Menütaste</translation>
    </message>
    <message>
        <source>what can be done with what is seen there</source>
        <translation>was sich mit dem tun lässt, was dort zu sehen ist</translation>
    </message>
    <message>
        <source>In an average every depth counts alike, so that there is no place to turn about.</source>
        <translation>In einem Mittelwert zählt jede Tiefe gleich viel, sodass es keine Stelle gibt, um die gedreht werden könnte.</translation>
    </message>
    <message>
        <source>Nothing is seen there.</source>
        <translation>Dort ist nichts zu sehen.</translation>
    </message>
    <message>
        <source>Enter, Backspace</source>
        <translation>Eingabe, Rücktaste</translation>
    </message>
    <message>
        <source>close a line of corners, take the last one back</source>
        <translation>Linie aus Ecken schließen, letzte Ecke zurücknehmen</translation>
    </message>
    <message>
        <source>zoom towards the pointer; range of a picked piece</source>
        <translation>zum Zeiger hin zoomen; Bereich eines gewählten Teils</translation>
    </message>
    <message>
        <source>View: %1</source>
        <translation>Ansicht: %1</translation>
    </message>
    <message>
        <source>Click the cube</source>
        <translation>Klick auf den Würfel</translation>
    </message>
    <message>
        <source>look from that side; once there: from the opposite one</source>
        <translation>Blick von dieser Seite; von dort aus: von gegenüber</translation>
    </message>
    <message>
        <source>what can be done there: take its label in hand, copy the value</source>
        <translation>was dort getan werden kann: sein Label auswählen, den Wert kopieren</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>mm²</source>
        <translation>mm²</translation>
    </message>
    <message>
        <source>voxels²</source>
        <translation>Voxel²</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>no voxels</source>
        <translation>keine Voxel</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>no angle: two places are one</source>
        <translation>kein Winkel: zwei Orte fallen zusammen</translation>
    </message>
    <message>
        <source>delete: %1</source>
        <translation>löschen: %1</translation>
    </message>
    <message>
        <source>mean ± standard deviation of %1 voxels</source>
        <translation>Mittelwert ± Standardabweichung von %1 Voxeln</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>%1 · opacity %2</source>
        <translation>%1 · Deckkraft %2</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Blick von vorn</translation>
    </message>
    <message>
        <source>Look from the back</source>
        <translation>Blick von hinten</translation>
    </message>
    <message>
        <source>Look from the left</source>
        <translation>Blick von links</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>Blick von rechts</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>Blick von oben</translation>
    </message>
    <message>
        <source>Look from below</source>
        <translation>Blick von unten</translation>
    </message>
    <message>
        <source>Look from the last column</source>
        <translation>Blick von der letzten Spalte</translation>
    </message>
    <message>
        <source>Look from the first column</source>
        <translation>Blick von der ersten Spalte</translation>
    </message>
    <message>
        <source>Look from the last row</source>
        <translation>Blick von der letzten Zeile</translation>
    </message>
    <message>
        <source>Look from the first row</source>
        <translation>Blick von der ersten Zeile</translation>
    </message>
    <message>
        <source>Look from the last slice</source>
        <translation>Blick von der letzten Schicht</translation>
    </message>
    <message>
        <source>Look from the first slice</source>
        <translation>Blick von der ersten Schicht</translation>
    </message>
    <message>
        <source>tools: distance, angle, ellipse, mark; Del: delete</source>
        <translation>Werkzeuge: Abstand, Winkel, Ellipse, Marke; Entf: löschen</translation>
    </message>
    <message>
        <source>change colour at %1</source>
        <translation>Farbe bei %1 ändern</translation>
    </message>
    <message>
        <source>opacity at %1 %2</source>
        <translation>Deckkraft bei %1: %2</translation>
    </message>
    <message>
        <source>move point %1, opacity %2</source>
        <translation>Punkt verschieben: %1, Deckkraft %2</translation>
    </message>
    <message>
        <source>move point %1</source>
        <translation>Punkt verschieben: %1</translation>
    </message>
    <message>
        <source> · Alt+1 … 9</source>
        <translation> · Alt+1 … 9</translation>
    </message>
    <message>
        <source>look from front, back, left, above, below; from kept views</source>
        <translation>Blick von vorn, hinten, links, oben, unten; von gemerkten Ansichten</translation>
    </message>
    <message>
        <source>cut open to the crosshair: plane, corner; Esc: as it was</source>
        <translation>bis zum Fadenkreuz aufschneiden: Ebene, Ecke; Esc: wie zuvor</translation>
    </message>
    <message>
        <source>tools: crosshair, window and level, cut, piece</source>
        <translation>Werkzeuge: Fadenkreuz, Fensterung, Schere, Teil</translation>
    </message>
    <message>
        <source>Normals smoothed by %1 mm</source>
        <translation>Normalen um %1&#xa0;mm geglättet</translation>
    </message>
    <message>
        <source>Physical</source>
        <translation>Physikalisch</translation>
    </message>
    <message>
        <source>density %1</source>
        <translation>Dichte %1</translation>
    </message>
    <message>
        <source>%1 · normals smoothed by %2 mm</source>
        <translation>%1 · Normalen um %2&#xa0;mm geglättet</translation>
    </message>
    <message>
        <source>1 path</source>
        <translation>1 Pfad</translation>
    </message>
    <message>
        <source>%1 paths</source>
        <translation>%1 Pfaden</translation>
    </message>
    <message>
        <source>%1, estimating…</source>
        <translation>nach %1, Schätzung läuft …</translation>
    </message>
    <message>
        <source>within %1 levels RMS after %2</source>
        <translation>höchstens %1 Stufen RMS nach %2</translation>
    </message>
    <message>
        <source>shadows not measured</source>
        <translation>Schatten nicht gemessen</translation>
    </message>
    <message>
        <source>step %1, light approximate</source>
        <translation>Schritt %1, Licht angenähert</translation>
    </message>
    <message>
        <source>random paths, refining</source>
        <translation>Zufallspfade, wird verfeinert</translation>
    </message>
    <message>
        <source>random paths</source>
        <translation>Zufallspfade</translation>
    </message>
    <message>
        <source>Light follows random paths through tissue, and what they differ by tells how far the picture lies from the exact one: %1 of 255 levels on average (RMS), 999 of 1000 colour values within %2. Four times as many paths halve it.</source>
        <translation>Licht folgt Zufallspfaden durch das Gewebe, und worin sie sich unterscheiden, sagt, wie weit das Bild neben dem exakten liegt: im Mittel (RMS) %1 von 255 Stufen, 999 von 1000 Farbwerten höchstens %2. Viermal so viele Pfade halbieren es.</translation>
    </message>
    <message>
        <source>%1 of each pixel</source>
        <translation>mit %1 je Bildpunkt</translation>
    </message>
    <message>
        <source>1 path a pixel</source>
        <translation>1 Pfad je Bildpunkt</translation>
    </message>
    <message>
        <source>%1 paths a pixel</source>
        <translation>%1 Pfade je Bildpunkt</translation>
    </message>
    <message>
        <source>Drawn for %1 of 255 levels of the exact picture; the file tells what was reached.</source>
        <translation>Gezeichnet für %1 von 255 Stufen am exakten Bild; die Datei sagt, was erreicht wurde.</translation>
    </message>
    <message>
        <source>Random paths: %1 a pixel</source>
        <translation>Zufallspfade: %1 je Bildpunkt</translation>
    </message>
    <message>
        <source>Random paths: %1 a pixel, standard error %2 of 255 levels RMS</source>
        <translation>Zufallspfade: %1 je Bildpunkt, Standardfehler %2 von 255 Stufen (RMS)</translation>
    </message>
    <message>
        <source>the picture alone; F11 or Esc: all again</source>
        <translation>nur das Bild; F11 oder Esc: wieder alles</translation>
    </message>
    <message>
        <source>Between %1 and %2; %3 % of all boundaries</source>
        <translation>Zwischen %1 und %2; %3&#xa0;% aller Grenzflächen</translation>
    </message>
    <message>
        <source>a quarter of the error: %1 paths, %2 s</source>
        <translation>ein Viertel des Fehlers: %1 Pfade, %2&#xa0;s</translation>
    </message>
    <message>
        <source>%1 paths, %2 s</source>
        <translation>%1 Pfade, %2&#xa0;s</translation>
    </message>
    <message>
        <source>law of chance, 1/√n</source>
        <translation>Gesetz des Zufalls, 1/√n</translation>
    </message>
    <message>
        <source>contrast %1 (RMS)</source>
        <translation>Kontrast %1 (RMS)</translation>
    </message>
    <message>
        <source>%1 % of the pixels brighter than white and cut off</source>
        <translation>%1&#xa0;% der Pixel heller als Weiß und abgeschnitten</translation>
    </message>
    <message>
        <source>Light: %1.</source>
        <translation>Licht: %1.</translation>
    </message>
    <message>
        <source>Light at the left: %1.</source>
        <translation>Licht links: %1.</translation>
    </message>
    <message>
        <source>Light at the right: %1.</source>
        <translation>Licht rechts: %1.</translation>
    </message>
    <message>
        <source>Scale at the depth of the turning point (perspective).</source>
        <translation>Maßstab in der Tiefe des Drehpunkts (perspektivisch).</translation>
    </message>
    <message>
        <source>Scale at the depth of the turning point (perspective: %1).</source>
        <translation>Maßstab in der Tiefe des Drehpunkts (perspektivisch: %1).</translation>
    </message>
    <message>
        <source>%1 at the pivot</source>
        <translation>%1 am Drehpunkt</translation>
    </message>
    <message>
        <source>&lt;p&gt;What lies nearer looks larger: the length holds at the depth of the turning point (pivot). View ▸ Orthographic has one scale everywhere.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Was näher liegt, sieht größer aus: Die Länge gilt in der Tiefe des Drehpunkts. „Ansicht ▸ Orthografisch“ hat überall denselben Maßstab.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>○ nearly exact</source>
        <translation>○ fast exakt</translation>
    </message>
    <message>
        <source>step %1 of the smallest voxel spacing, %2 mm</source>
        <translation>Schrittweite %1 des kleinsten Voxelabstands, %2&#xa0;mm</translation>
    </message>
    <message>
        <source>colour and numbers, of all that are selected with it</source>
        <translation>Farbe und Zahlen, auch aller mit ihm ausgewählten</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Posterior</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>Superior</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Inferior</translation>
    </message>
    <message>
        <source>Random paths: %1 a pixel, their noise filtered, about %2 of 255 levels RMS left</source>
        <translation>Zufallspfade: %1 je Bildpunkt, Rauschen gefiltert, etwa %2 von 255 Stufen RMS verbleiben</translation>
    </message>
    <message>
        <source>From the file: %1</source>
        <translation>Aus der Datei: %1</translation>
    </message>
    <message>
        <source>From the file: %1, %2</source>
        <translation>Aus der Datei: %1, %2</translation>
    </message>
    <message>
        <source>paths until %1 of 255 levels of noise are left</source>
        <translation>Pfade, bis %1 von 255 Stufen Rauschen übrig sind</translation>
    </message>
    <message>
        <source>paths for %1 s</source>
        <translation>Pfade für %1&#xa0;s</translation>
    </message>
    <message>
        <source>%1, noise filtered</source>
        <comment>paths</comment>
        <translation>%1, Rauschen gefiltert</translation>
    </message>
    <message>
        <source>tools, in slices, too: cut, piece, distance, angle, ellipse, mark</source>
        <translation>Werkzeuge, auch in Schichten: schneiden, Stück, Abstand, Winkel, Ellipse, Marke</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <comment>a time</comment>
        <translation>etwa %1&#xa0;s</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <comment>a time</comment>
        <translation>etwa %1&#xa0;min</translation>
    </message>
    <message>
        <source>about %1 h</source>
        <comment>a time</comment>
        <translation>etwa %1&#xa0;h</translation>
    </message>
    <message>
        <source>(%1 left)</source>
        <comment>a time</comment>
        <translation>(noch %1)</translation>
    </message>
    <message>
        <source>left-hand</source>
        <translation>linke</translation>
    </message>
    <message>
        <source>right-hand</source>
        <translation>rechte</translation>
    </message>
    <message>
        <source>near</source>
        <translation>nahe</translation>
    </message>
    <message>
        <source>far</source>
        <translation>ferne</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>untere</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>obere</translation>
    </message>
    <message>
        <source>turned box: move %1 face</source>
        <translation>Fläche der gedrehten Box verschieben: %1</translation>
    </message>
    <message>
        <source>Turned box, %1</source>
        <translation>Gedrehte Box, %1</translation>
    </message>
    <message>
        <source>The steps are meant to cost half a level at most: smaller ones would show no difference.</source>
        <translation>Die Schritte sollen höchstens eine halbe Stufe kosten: Mit kleineren wäre kein Unterschied zu sehen.</translation>
    </message>
    <message>
        <source>steps chosen by error, meant for %1 of 255 levels</source>
        <translation>Schritte nach dem Fehler gewählt, für %1 von 255 Stufen</translation>
    </message>
    <message>
        <source>How long drawing takes is not known: light is found anew for each frame.</source>
        <translation>Wie lange das Zeichnen dauert, ist nicht bekannt: Das Licht wird für jedes Einzelbild neu ermittelt.</translation>
    </message>
    <message>
        <source>Drawing takes %1.</source>
        <comment>a time</comment>
        <translation>Das Zeichnen dauert %1.</translation>
    </message>
    <message>
        <source>How long drawing takes is known once the picture is complete.</source>
        <translation>Wie lange das Zeichnen dauert, ist bekannt, sobald das Bild vollständig ist.</translation>
    </message>
    <message>
        <source>Ctrl+click points, drag a frame</source>
        <translation>Strg+Klick auf Punkte, Rahmen ziehen</translation>
    </message>
    <message>
        <source>select several, to move or change together</source>
        <translation>mehrere auswählen, um sie gemeinsam zu verschieben oder zu ändern</translation>
    </message>
    <message>
        <source>Of the colour values of the pixels that were drawn 999 of 1000 lie within %1 levels of the exact picture.</source>
        <translation>Von den Farbwerten der gezogenen Pixel liegen 999 von 1000 höchstens %1 Stufen vom exakten Bild.</translation>
    </message>
    <message>
        <source>All of them: %1</source>
        <translation>Alle: %1</translation>
    </message>
    <message>
        <source>cut by hand</source>
        <translation>von Hand beschnitten</translation>
    </message>
    <message>
        <source>1 piece hidden</source>
        <translation>1 Teil ausgeblendet</translation>
    </message>
    <message>
        <source>%1 pieces hidden</source>
        <translation>%1 Teile ausgeblendet</translation>
    </message>
    <message>
        <source>Single pixels lie farther off than the steps are meant for; &quot;Show where it is not exact&quot; in the accuracy panel shows where.</source>
        <translation>Einzelne Pixel weichen weiter ab, als die Schritte vorsehen; „Zeigen, wo es nicht exakt ist“ im Bedienfeld Genauigkeit zeigt, wo.</translation>
    </message>
    <message>
        <source>It stays as it is while &quot;Sharpen while nothing moves&quot; is off in the settings, and while accuracy is measured.</source>
        <translation>Es bleibt so, solange „Im Stillstand verfeinern“ in den Einstellungen aus ist und solange die Genauigkeit gemessen wird.</translation>
    </message>
    <message>
        <source>Labels have curves of their own</source>
        <translation>Labels haben eigene Kurven</translation>
    </message>
    <message>
        <source>only one piece</source>
        <translation>nur ein Teil</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <comment>names</comment>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>Only the body, %1</source>
        <comment>what was cut</comment>
        <translation>Nur der Körper, %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>labels hidden, their names</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%L1 voxel holds no data and is shown as the smallest value.</source>
        <translation>%L1 Voxel enthält keine Daten und wird als kleinster Wert gezeigt.</translation>
    </message>
    <message>
        <source>%1 voxel = %2 mm</source>
        <translation>%1 Voxel = %2&#xa0;mm</translation>
    </message>
    <message>
        <source>%1: on</source>
        <translation>%1: ein</translation>
    </message>
    <message>
        <source>%1: off</source>
        <translation>%1: aus</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>Curves in colour are of the labels listed in these colours; the other curve is of the rest</source>
        <translation>Farbige Kurven gehören zu den Labels, die in diesen Farben aufgeführt sind; die andere Kurve gehört zum Rest</translation>
    </message>
    <message>
        <source>Curves in colour are of the labels listed in these colours, those of %1 more are not drawn, and the other curve is of the rest</source>
        <translation>Farbige Kurven gehören zu den Labels, die in diesen Farben aufgeführt sind; die von %1 weiteren sind nicht gezeichnet, und die andere Kurve gehört zum Rest</translation>
    </message>
    <message>
        <source>mean ± standard deviation of %1 voxel</source>
        <translation>Mittelwert ± Standardabweichung von %1 Voxel</translation>
    </message>
    <message>
        <source>%1, fitted</source>
        <comment>a preset</comment>
        <translation>%1, angepasst</translation>
    </message>
    <message>
        <source>Shadows and occlusion come from few paths or a grid of light, which smaller steps do not make finer; with a tolerance the processor follows more paths, which takes some minutes.</source>
        <translation>Schatten und Verdeckung kommen von wenigen Lichtpfaden oder einem Lichtgitter, die kleinere Schritte nicht feiner machen; mit einer Toleranz folgt der Prozessor mehr Pfaden, was einige Minuten dauert.</translation>
    </message>
    <message>
        <source>within %1 of 255 levels, measured in a smaller picture</source>
        <translation>auf %1 von 255 Stufen genau, in einem kleineren Bild gemessen</translation>
    </message>
    <message>
        <source>d MMM yyyy, HH:mm</source>
        <comment>as Qt formats dates</comment>
        <translation>d. MMM yyyy, HH:mm</translation>
    </message>
    <message>
        <source>OpenGL looks shadows and occlusion up on a grid and cannot say what that is off by. Pictures that are sharpened while nothing moves the processor draws once more, and says it.</source>
        <translation>OpenGL schlägt Schatten und Verdeckung auf einem Gitter nach und kann nicht sagen, wie weit das abliegt. Bilder, die geschärft werden, solange sich nichts bewegt, zeichnet der Prozessor noch einmal und sagt es.</translation>
    </message>
    <message>
        <source>This is the left picture; the right one lies closer to its exact one.</source>
        <translation>Das ist das linke Bild; das rechte liegt näher an seinem exakten.</translation>
    </message>
    <message>
        <source>This is the right picture; the left one lies closer to its exact one.</source>
        <translation>Das ist das rechte Bild; das linke liegt näher an seinem exakten.</translation>
    </message>
    <message>
        <source>the folder shown above; files are not listed</source>
        <translation>der oben gezeigte Ordner; Dateien sind nicht aufgeführt</translation>
    </message>
    <message>
        <source>Enter or a double click closes the line. Esc takes it back.</source>
        <translation>Eingabe oder ein Doppelklick schließt die Linie. Esc nimmt sie zurück.</translation>
    </message>
    <message>
        <source>Show what was cut away</source>
        <translation>Weggeschnittenes zeigen</translation>
    </message>
    <message>
        <source>A click shows what was cut away again; a second one shows everything.</source>
        <translation>Ein Klick zeigt wieder, was weggeschnitten wurde; ein zweiter zeigt alles.</translation>
    </message>
</context>
<context>
    <name>Tissue</name>
    <message>
        <source>air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>fat</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>soft tissue, blood</source>
        <translation>Weichteile, Blut</translation>
    </message>
    <message>
        <source>contrast agent, spongy bone</source>
        <translation>Kontrastmittel, Spongiosa</translation>
    </message>
    <message>
        <source>bone, dense contrast agent</source>
        <translation>Knochen, dichtes Kontrastmittel</translation>
    </message>
    <message>
        <source>compact bone, dentine</source>
        <translation>Kompakta, Dentin</translation>
    </message>
    <message>
        <source>enamel, metal</source>
        <translation>Zahnschmelz, Metall</translation>
    </message>
</context>
<context>
    <name>limn::AccuracyChart</name>
    <message>
        <source>Chart of error against time</source>
        <translation>Diagramm des Fehlers über der Zeit</translation>
    </message>
    <message>
        <source>%1 measured points; left and right walk through them, Enter uses one.</source>
        <translation>%1 gemessene Punkte; mit den Pfeiltasten links und rechts durchgehen, Eingabe wählt einen.</translation>
    </message>
    <message>
        <source>&lt;p&gt;Measured for an earlier picture.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Für ein früheres Bild gemessen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Click to use it.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Klicken, um ihn zu verwenden.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>limn::AccuracyController</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Choose one picture or side by side: here two pictures lie over each other.</source>
        <translation>Wählen Sie ein einzelnes Bild oder „Nebeneinander“: Hier liegen zwei Bilder übereinander.</translation>
    </message>
    <message>
        <source>Save what was measured</source>
        <translation>Messung speichern</translation>
    </message>
    <message>
        <source>Page with chart and table (*.html)</source>
        <translation>Seite mit Diagramm und Tabelle (*.html)</translation>
    </message>
    <message>
        <source>Chart (*.png)</source>
        <translation>Diagramm (*.png)</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>&amp;Accuracy</source>
        <translation>&amp;Genauigkeit</translation>
    </message>
    <message>
        <source>Sharpen while nothing &amp;moves</source>
        <translation>Im Stillstand &amp;verfeinern</translation>
    </message>
    <message>
        <source>While nothing moves, draws the picture again with smaller and smaller steps until it lies within half a level of the exact one.</source>
        <translation>Zeichnet das Bild, solange sich nichts bewegt, mit immer kleineren Schritten neu, bis es höchstens eine halbe Stufe neben dem exakten liegt.</translation>
    </message>
    <message>
        <source>The picture changed before it was compared with the exact one; tick the box to begin again.</source>
        <translation>Das Bild änderte sich, ehe es mit dem exakten verglichen war; zum Neubeginn das Kästchen anhaken.</translation>
    </message>
    <message>
        <source>at the right %1</source>
        <comment>how far a picture is off</comment>
        <translation>rechts %1</translation>
    </message>
</context>
<context>
    <name>limn::AccuracyMeasurer</name>
    <message>
        <source>The accuracy cannot be measured. %1</source>
        <translation>Die Genauigkeit kann nicht gemessen werden. %1</translation>
    </message>
</context>
<context>
    <name>limn::AccuracyPanel</name>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Open a volume first.</source>
        <translation>Öffnen Sie zuerst ein Volumen.</translation>
    </message>
    <message>
        <source>Wait until the measuring is done.</source>
        <translation>Warten Sie, bis die Messung fertig ist.</translation>
    </message>
    <message>
        <source>use %1</source>
        <translation>verwenden: %1</translation>
    </message>
    <message>
        <source>Preparing…</source>
        <translation>Vorbereitung…</translation>
    </message>
    <message>
        <source>Measuring first; the best picture that keeps this is then used.</source>
        <translation>Zuerst wird gemessen; dann gilt das beste Bild, das dies einhält.</translation>
    </message>
</context>
<context>
    <name>limn::ActionList</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>&amp;Preset</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>Weitere Werkzeuge</translation>
    </message>
    <message>
        <source>Tools that find no room here.</source>
        <translation>Werkzeuge, die hier keinen Platz finden.</translation>
    </message>
</context>
<context>
    <name>limn::BackgroundWork</name>
    <message>
        <source>There is not enough memory for this; close other programs or ask for something smaller.</source>
        <translation>Der Speicher reicht dafür nicht; schließen Sie andere Programme, oder wählen Sie etwas Kleineres.</translation>
    </message>
    <message>
        <source>An unexpected error: %1.</source>
        <translation>Unerwarteter Fehler: %1.</translation>
    </message>
</context>
<context>
    <name>limn::Callout</name>
    <message>
        <source>End tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
</context>
<context>
    <name>limn::CameraController</name>
    <message>
        <source>&amp;Orthographic</source>
        <translation>&amp;Orthografisch</translation>
    </message>
    <message>
        <source>Parallel rays: sizes can be compared everywhere in the picture.</source>
        <translation>Parallele Strahlen: Größen lassen sich überall im Bild vergleichen.</translation>
    </message>
    <message>
        <source>Camera back</source>
        <translation>Kamera zurück</translation>
    </message>
    <message>
        <source>Looks again from where it was before the last turn, move, zoom or view.</source>
        <translation>Blickt wieder von dort, wo sie vor dem letzten Drehen, Verschieben, Zoomen oder Blick stand.</translation>
    </message>
    <message>
        <source>Camera forward</source>
        <translation>Kamera vor</translation>
    </message>
    <message>
        <source>Looks from where it was before &quot;Camera back&quot; was chosen.</source>
        <translation>Blickt von dort, wo sie stand, bevor „Kamera zurück“ gewählt wurde.</translation>
    </message>
    <message>
        <source>Turns go about what is seen there. R resets the camera and ends that.</source>
        <translation>Gedreht wird um das, was dort zu sehen ist. R setzt die Kamera zurück und beendet das.</translation>
    </message>
    <message>
        <source>Turns go about the middle of the view.</source>
        <translation>Gedreht wird um die Bildmitte.</translation>
    </message>
</context>
<context>
    <name>limn::ChartWindow</name>
    <message>
        <source>Error against time</source>
        <translation>Fehler über der Zeit</translation>
    </message>
</context>
<context>
    <name>limn::ChoiceRow</name>
    <message>
        <source>&lt;p&gt;%1&lt;/p&gt;&lt;p&gt;%2; default %3. Double click on the name to reset.&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1&lt;/p&gt;&lt;p&gt;%2; Standard %3. Doppelklick auf den Namen setzt zurück.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>limn::ColorButton</name>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
</context>
<context>
    <name>limn::ColorPicker</name>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour as hex code</source>
        <translation>Farbe als Hexcode</translation>
    </message>
    <message>
        <source>The colour as a hex code, from #000000 (black) to #ffffff (white)</source>
        <translation>Die Farbe als Hexcode, von #000000 (Schwarz) bis #ffffff (Weiß)</translation>
    </message>
    <message>
        <source>Arrows: saturation and brightness. Page Up, Page Down: hue. 1 to 8: the colours of tissues.</source>
        <translation>Pfeiltasten: Sättigung und Helligkeit. Bild auf, Bild ab: Farbton. 1 bis 8: die Farben der Gewebe.</translation>
    </message>
    <message>
        <source>%1 is no colour: give a hex code such as %2.</source>
        <translation>%1 ist keine Farbe: Geben Sie einen Hex-Code wie %2 an.</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Fat</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Muscle</source>
        <translation>Muskel</translation>
    </message>
    <message>
        <source>Vessel</source>
        <translation>Gefäß</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>Metall</translation>
    </message>
    <message>
        <source>%1 (key %2)</source>
        <translation>%1 (Taste %2)</translation>
    </message>
    <message>
        <source>Enter keeps it, Esc takes it back.</source>
        <translation>Eingabe behält sie, Esc nimmt sie zurück.</translation>
    </message>
</context>
<context>
    <name>limn::CompareView</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Drag to rotate, middle drag to pan, right drag or wheel to zoom; arrows rotate, + and − zoom</source>
        <translation>Ziehen dreht, Ziehen mit der mittleren Taste verschiebt, Ziehen mit rechts oder das Mausrad zoomt; Pfeiltasten drehen, + und − zoomen</translation>
    </message>
    <message>
        <source>Getting the volume ready for drawing…</source>
        <translation>Volumen wird zum Zeichnen vorbereitet…</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>Swap the sides</source>
        <translation>Seiten tauschen</translation>
    </message>
</context>
<context>
    <name>limn::ComparisonController</name>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>%1, modified</source>
        <comment>a preset</comment>
        <translation>%1, verändert</translation>
    </message>
    <message>
        <source>Si&amp;ngle</source>
        <translation>E&amp;inzeln</translation>
    </message>
    <message>
        <source>Si&amp;de by side</source>
        <translation>&amp;Nebeneinander</translation>
    </message>
    <message>
        <source>Two models beside each other.</source>
        <translation>Zwei Modelle nebeneinander.</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>&amp;Vorhang</translation>
    </message>
    <message>
        <source>Two models over each other with a border to drag.</source>
        <translation>Zwei Modelle übereinander mit verschiebbarer Trennlinie.</translation>
    </message>
    <message>
        <source>Di&amp;fference</source>
        <translation>&amp;Differenz</translation>
    </message>
    <message>
        <source>Where the two models differ, amplified.</source>
        <translation>Wo sich die beiden Modelle unterscheiden; Unterschiede vergrößert.</translation>
    </message>
    <message>
        <source>&amp;Remember this look as &quot;before&quot;</source>
        <translation>Diese Darstellung als „vorher“ &amp;merken</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>Keeps curve and light of this moment to compare with what becomes of them.</source>
        <translation>Merkt sich Kurve und Licht dieses Augenblicks, um sie mit späteren zu vergleichen.</translation>
    </message>
    <message>
        <source>Compare &amp;before and now</source>
        <translation>&amp;Vorher und jetzt vergleichen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>Shows the remembered look at the left, the present one at the right.</source>
        <translation>Zeigt links die gemerkte Darstellung, rechts die jetzige.</translation>
    </message>
    <message>
        <source>Compare &amp;models again</source>
        <translation>Wieder M&amp;odelle vergleichen</translation>
    </message>
    <message>
        <source>Ends the comparison of two looks.</source>
        <translation>Beendet den Vergleich zweier Darstellungen.</translation>
    </message>
    <message>
        <source>&amp;Model</source>
        <translation>&amp;Modell</translation>
    </message>
    <message>
        <source>R&amp;ight model</source>
        <translation>&amp;Rechtes Modell</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>Left: %1</source>
        <translation>Links: %1</translation>
    </message>
    <message>
        <source>Right: %1</source>
        <translation>Rechts: %1</translation>
    </message>
    <message>
        <source>The shading model of the picture: how tissue is lit.</source>
        <translation>Das Schattierungsmodell des Bildes: wie Gewebe beleuchtet wird.</translation>
    </message>
    <message>
        <source>The shading model of the left side.</source>
        <translation>Das Schattierungsmodell der linken Seite.</translation>
    </message>
    <message>
        <source>The shading model of the right side.</source>
        <translation>Das Schattierungsmodell der rechten Seite.</translation>
    </message>
    <message>
        <source>Model: %1</source>
        <translation>Modell: %1</translation>
    </message>
    <message>
        <source>Left &amp;model</source>
        <translation>&amp;Linkes Modell</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>&amp;Preset</translation>
    </message>
    <message>
        <source>%1, before</source>
        <comment>a preset</comment>
        <translation>%1, vorher</translation>
    </message>
    <message>
        <source>compare models</source>
        <translation>Modelle vergleichen</translation>
    </message>
    <message>
        <source>S&amp;wap the sides</source>
        <translation>Seite&amp;n tauschen</translation>
    </message>
    <message>
        <source>From now on what is at the left stands at the right, and the other way round; of two looks the right one is edited. Space shows the other side while it is held.</source>
        <translation>Was links steht, steht von jetzt an rechts und umgekehrt; von zwei Darstellungen wird die rechte bearbeitet. Die Leertaste zeigt die andere Seite, solange sie gedrückt ist.</translation>
    </message>
    <message>
        <source>swap the sides</source>
        <translation>Seiten tauschen</translation>
    </message>
    <message>
        <source>one picture: %1</source>
        <comment>a model</comment>
        <translation>ein Bild: %1</translation>
    </message>
    <message>
        <source>One picture; of two models that of the side you worked in last.</source>
        <translation>Ein Bild; von zwei Modellen das der Seite, an der Sie zuletzt gearbeitet haben.</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Remembered; Ctrl+Shift+B compares with this look.</source>
        <translation>Gemerkt; Ctrl+Shift+B vergleicht mit dieser Darstellung.</translation>
    </message>
    <message>
        <source>Remembered; Ctrl+Shift+B compares with &quot;%1&quot;.</source>
        <comment>a look</comment>
        <translation>Gemerkt; Ctrl+Shift+B vergleicht mit „%1“.</translation>
    </message>
    <message>
        <source>Other look</source>
        <translation>Anderer Look</translation>
    </message>
</context>
<context>
    <name>limn::CropBoxController</name>
    <message>
        <source>&amp;Crop box</source>
        <translation>&amp;Zuschnittbox</translation>
    </message>
    <message>
        <source>Shows a box with handles in the picture; what is outside is cut away. (B)</source>
        <translation>Zeigt eine Box mit Griffen im Bild; was außerhalb liegt, wird abgeschnitten. (B)</translation>
    </message>
    <message>
        <source>crop box around the body</source>
        <translation>Zuschnittbox um den Körper</translation>
    </message>
</context>
<context>
    <name>limn::CropSection</name>
    <message>
        <source>What lies outside this part of the volume is cut away; the first number is the end named first.</source>
        <translation>Was außerhalb dieser Prozentwerte des Volumens liegt, wird abgeschnitten; die erste Zahl gehört zum zuerst genannten Ende.</translation>
    </message>
    <message>
        <source>Columns %1–%2 of %3</source>
        <translation>Spalten %1–%2 von %3</translation>
    </message>
    <message>
        <source>Rows %1–%2 of %3</source>
        <translation>Zeilen %1–%2 von %3</translation>
    </message>
    <message>
        <source>Slices %1–%2 of %3</source>
        <translation>Schichten %1–%2 von %3</translation>
    </message>
    <message>
        <source> · %1 mm</source>
        <translation> · %1&#xa0;mm</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Zuschnitt</translation>
    </message>
    <message>
        <source>Reset crop</source>
        <translation>Zuschnitt zurücksetzen</translation>
    </message>
    <message>
        <source>Shows the whole volume again.</source>
        <translation>Zeigt wieder das ganze Volumen.</translation>
    </message>
    <message>
        <source>reset crop</source>
        <translation>Zuschnitt zurücksetzen</translation>
    </message>
    <message>
        <source>crop %1</source>
        <translation>%1 zuschneiden</translation>
    </message>
    <message>
        <source>%1 % kept</source>
        <translation>%1&#xa0;% behalten</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Crop to what is seen</source>
        <translation>Auf Sichtbares zuschneiden</translation>
    </message>
    <message>
        <source>&lt;p&gt;Draws the box close around what the curve, Body only and labels leave to be seen, so that its handles lie there and not around air and table.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Zieht die Box eng um das, was Kurve, „Nur Körper“ und Labels sehen lassen, damit ihre Griffe dort liegen und nicht um Luft und Tisch.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>crop to what is seen</source>
        <translation>auf Sichtbares zuschneiden</translation>
    </message>
    <message>
        <source>Turn to this view</source>
        <translation>In diese Ansicht drehen</translation>
    </message>
    <message>
        <source>Puts a box over the picture that lies as the picture is seen now.</source>
        <translation>Legt eine Box über das Bild, die so liegt, wie das Bild jetzt zu sehen ist.</translation>
    </message>
    <message>
        <source>Crop of %1</source>
        <translation>Zuschnitt von %1</translation>
    </message>
    <message>
        <source>%1 Millimetres from that end can be typed, too: 48 mm.</source>
        <translation>%1 Auch Millimeter von diesem Ende aus können eingegeben werden: 48&#xa0;mm.</translation>
    </message>
</context>
<context>
    <name>limn::CrosshairController</name>
    <message>
        <source>Cut o&amp;pen to the crosshair</source>
        <translation>Bis zum Fadenkreuz auf&amp;schneiden</translation>
    </message>
    <message>
        <source>Nothing lies before the crosshair on this side, so nothing was cut.</source>
        <translation>Auf dieser Seite liegt nichts vor dem Fadenkreuz; es wurde nichts weggeschnitten.</translation>
    </message>
    <message>
        <source>cut open to the crosshair</source>
        <translation>bis zum Fadenkreuz aufschneiden</translation>
    </message>
    <message>
        <source>Cut open to the crosshair, %1. The cut goes with the crosshair; Esc closes it.</source>
        <translation>Bis zum Fadenkreuz aufgeschnitten, %1. Der Schnitt geht mit dem Fadenkreuz; Esc schließt ihn.</translation>
    </message>
    <message>
        <source>close the cut</source>
        <translation>Schnitt schließen</translation>
    </message>
    <message>
        <source>&lt;p&gt;Cuts away what lies before the slices&apos; crosshair in the picture, on the side that faces you most (O). Again, or Esc: as it was.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Schneidet im Bild weg, was vor dem Fadenkreuz der Schnitte liegt, auf der Seite, die Ihnen am meisten zugewandt ist (O). Nochmals oder Esc: wie zuvor.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Cut open the co&amp;rner to the crosshair</source>
        <translation>Ec&amp;ke bis zum Fadenkreuz aufschneiden</translation>
    </message>
    <message>
        <source>The corner is cut open to the crosshair. The cut goes with the crosshair; Esc closes it.</source>
        <translation>Die Ecke ist bis zum Fadenkreuz aufgeschnitten. Der Schnitt geht mit dem Fadenkreuz mit; Esc schließt ihn.</translation>
    </message>
    <message>
        <source>Cut open to the crosshair</source>
        <translation>Bis zum Fadenkreuz aufgeschnitten</translation>
    </message>
    <message>
        <source>cut the corner open to the crosshair</source>
        <translation>Ecke bis zum Fadenkreuz aufschneiden</translation>
    </message>
    <message>
        <source>&lt;p&gt;Cuts away the corner that faces you, up to the slices&apos; crosshair, so that three slices are seen in the picture (Shift+O). Again, or Esc: as it was.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Schneidet die Ecke, die zu Ihnen zeigt, bis zum Fadenkreuz der Schichten weg, sodass im Bild drei Schichten zu sehen sind (Umschalt+O). Noch einmal oder Esc: wie zuvor.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Choose a layout with slices first (View ▸ Slices): they have the crosshair.</source>
        <translation>Zuerst eine Anordnung mit Schnitten wählen (Ansicht ▸ Schnitte): Sie haben das Fadenkreuz.</translation>
    </message>
</context>
<context>
    <name>limn::CurveController</name>
    <message>
        <source>The volume&apos;s gradients cannot be counted: %1.</source>
        <translation>Die Gradienten des Volumens können nicht gezählt werden: %1.</translation>
    </message>
    <message>
        <source>Transfer f&amp;unction</source>
        <translation>&amp;Transferfunktion</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Piece %1</source>
        <translation>Teil %1</translation>
    </message>
</context>
<context>
    <name>limn::CurvePanel</name>
    <message>
        <source>Opacity over</source>
        <translation>Deckkraft über</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Opacity over value</source>
        <translation>Deckkraft über dem Wert</translation>
    </message>
    <message>
        <source>&lt;p&gt;How opaque tissue is by its value: the transfer function.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Wie deckend Gewebe nach seinem Wert ist: die Transferfunktion.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Gradient</translation>
    </message>
    <message>
        <source>Opacity over gradient</source>
        <translation>Deckkraft über dem Gradienten</translation>
    </message>
    <message>
        <source>&lt;p&gt;How much of the opacity is left by how fast the value changes, so that boundaries stay.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Wie viel von der Deckkraft bleibt, je nachdem wie schnell sich der Wert ändert, sodass Grenzflächen stehen bleiben.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;This projection does not add up opacities along its rays; tissue does.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Diese Projektion addiert keine Deckkraft entlang ihrer Strahlen; die Projektion „Gewebe“ tut es.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Gradient: off</source>
        <translation>Gradient: aus</translation>
    </message>
    <message>
        <source>Gradient: on</source>
        <translation>Gradient: an</translation>
    </message>
    <message>
        <source>Gradient: unused</source>
        <translation>Gradient: ungenutzt</translation>
    </message>
    <message>
        <source>Whose curve</source>
        <translation>Wessen Kurve</translation>
    </message>
    <message>
        <source>&lt;p&gt;Whose curve is shown and edited: the one for all tissue, or that of a label that has its own (Properties ▸ Labels).&lt;/p&gt;</source>
        <translation>&lt;p&gt;Wessen Kurve gezeigt und bearbeitet wird: die für alles Gewebe oder die eines Labels, das eine eigene hat (Eigenschaften ▸ Labels).&lt;/p&gt;</translation>
    </message>
    <message>
        <source>All tissue</source>
        <translation>Alles Gewebe</translation>
    </message>
</context>
<context>
    <name>limn::CutBar</name>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Außen</translation>
    </message>
    <message>
        <source>Through all</source>
        <translation>Durch alles</translation>
    </message>
    <message>
        <source>What is seen</source>
        <translation>Nur Sichtbares</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Only this</source>
        <translation>Nur dieses</translation>
    </message>
    <message>
        <source>Takes away what the line goes around.</source>
        <translation>Nimmt weg, was die Linie umschließt.</translation>
    </message>
    <message>
        <source>Takes away all that the line does not go around.</source>
        <translation>Nimmt alles weg, was die Linie nicht umschließt.</translation>
    </message>
    <message>
        <source>Cuts through the whole volume.</source>
        <translation>Schneidet durch das ganze Volumen.</translation>
    </message>
    <message>
        <source>Hides this piece.</source>
        <translation>Blendet dieses Teil aus.</translation>
    </message>
    <message>
        <source>Hides all but this piece.</source>
        <translation>Blendet alles außer diesem Teil aus.</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Draw around it, or click corners</source>
        <translation>Umfahren oder Ecken anklicken</translation>
    </message>
    <message>
        <source>Shift draws straight on; Enter, a double click or the first corner closes a line of corners, Backspace takes the last one back, Esc all.</source>
        <translation>Umschalt zeichnet gerade weiter; Eingabe, ein Doppelklick oder die erste Ecke schließt eine Linie aus Ecken, die Rücktaste nimmt die letzte zurück, Esc alle.</translation>
    </message>
    <message>
        <source>Its own curve</source>
        <translation>Eigene Kurve</translation>
    </message>
    <message>
        <source>Gives this piece a curve of its own, which the curve panel then shows.</source>
        <translation>Gibt diesem Teil eine eigene Kurve, die dann der Kurvenbereich zeigt.</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>Weniger</translation>
    </message>
    <message>
        <source>The wheel widens or narrows the range of values, with Shift its upper end alone; the value at the place that you clicked stays within it. Another click picks another piece, Esc none.</source>
        <translation>Das Rad weitet oder verengt den Wertebereich, mit Umschalt nur sein oberes Ende; der Wert an der angeklickten Stelle bleibt darin. Ein weiterer Klick wählt ein anderes Stück, Esc keines.</translation>
    </message>
    <message>
        <source>Takes less of what hangs together: similar values, or what lies near.</source>
        <translation>Nimmt weniger von dem, was zusammenhängt: ähnliche Werte oder was nahe liegt.</translation>
    </message>
    <message>
        <source>Values like those around the place</source>
        <translation>Werte wie rund um die Stelle</translation>
    </message>
    <message>
        <source>However far it reaches</source>
        <translation>So weit es reicht</translation>
    </message>
    <message>
        <source>Within %1 of the place</source>
        <translation>Höchstens %1 von der Stelle</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Cuts only as deep as what is seen inside the line, and leaves what shows far behind through small gaps; in a slice, as deep as its slab, at least one slice.</source>
        <translation>Schneidet nur so tief, wie innerhalb der Linie etwas zu sehen ist, und lässt stehen, was weit dahinter durch kleine Lücken scheint; in einer Schicht so tief wie deren Dicke, mindestens eine Schicht.</translation>
    </message>
</context>
<context>
    <name>limn::CutController</name>
    <message>
        <source>%1 – %2 · %3 ml · mean %4</source>
        <translation>%1 – %2 · %3 ml · Mittel %4</translation>
    </message>
    <message>
        <source>Looking for what hangs together…</source>
        <translation>Suche, was zusammenhängt…</translation>
    </message>
    <message>
        <source>cut away inside a line</source>
        <translation>innerhalb einer Linie wegschneiden</translation>
    </message>
    <message>
        <source>cut away outside a line</source>
        <translation>außerhalb einer Linie wegschneiden</translation>
    </message>
    <message>
        <source>Nothing is seen inside the line, so nothing was cut.</source>
        <translation>Innerhalb der Linie ist nichts zu sehen, daher wurde nichts geschnitten.</translation>
    </message>
    <message>
        <source>Nothing that the curve shows lies there, so there is no piece to pick.</source>
        <translation>Dort liegt nichts, was die Kurve zeigt, also gibt es kein Teil zu wählen.</translation>
    </message>
    <message>
        <source>keep a piece alone</source>
        <translation>nur ein Teil behalten</translation>
    </message>
    <message>
        <source>hide a piece</source>
        <translation>ein Teil ausblenden</translation>
    </message>
    <message>
        <source>the piece that hangs together</source>
        <translation>das zusammenhängende Teil</translation>
    </message>
    <message>
        <source>give a piece its own curve</source>
        <translation>Teil mit eigener Kurve</translation>
    </message>
    <message>
        <source>%1 – %2 · %3 ml · no narrower by the wheel</source>
        <translation>%1 – %2 · %3&#xa0;ml · mit dem Rad nicht enger</translation>
    </message>
    <message>
        <source>Click what is meant; the wheel then takes less or more</source>
        <translation>Anklicken, was gemeint ist; das Rad nimmt dann weniger oder mehr</translation>
    </message>
    <message>
        <source>Enter or a double click closes the line. Esc takes it back.</source>
        <translation>Eingabe oder ein Doppelklick schließt die Linie. Esc nimmt sie zurück.</translation>
    </message>
</context>
<context>
    <name>limn::CutSection</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 on</source>
        <translation>%1 aktiv</translation>
    </message>
    <message>
        <source>%1 of %2 on</source>
        <translation>%1 von %2 aktiv</translation>
    </message>
    <message>
        <source>Scissors, inside</source>
        <translation>Schere, innen</translation>
    </message>
    <message>
        <source>Scissors, outside</source>
        <translation>Schere, außen</translation>
    </message>
    <message>
        <source>%1, what is seen</source>
        <translation>%1, nur Sichtbares</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>Piece %1, alone</source>
        <translation>Teil %1, allein</translation>
    </message>
    <message>
        <source>Piece %1, hidden</source>
        <translation>Teil %1, ausgeblendet</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>Pick a piece</source>
        <translation>Teil wählen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Cuts along a line that you draw on the picture (X).</source>
        <translation>Schneidet entlang einer Linie, die Sie auf das Bild zeichnen (X).</translation>
    </message>
    <message>
        <source>Makes the chosen cut earlier.</source>
        <translation>Zieht den gewählten Schnitt vor.</translation>
    </message>
    <message>
        <source>Makes the chosen cut later.</source>
        <translation>Stellt den gewählten Schnitt zurück.</translation>
    </message>
    <message>
        <source>Takes the chosen cut back.</source>
        <translation>Nimmt den gewählten Schnitt zurück.</translation>
    </message>
    <message>
        <source>switch cut %1 on</source>
        <translation>Schnitt %1 einschalten</translation>
    </message>
    <message>
        <source>switch cut %1 off</source>
        <translation>Schnitt %1 ausschalten</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>move cut %1</source>
        <translation>Schnitt %1 verschieben</translation>
    </message>
    <message>
        <source>delete cut %1</source>
        <translation>Schnitt %1 löschen</translation>
    </message>
    <message>
        <source>Piece %1, own curve</source>
        <translation>Teil %1, eigene Kurve</translation>
    </message>
    <message>
        <source>Hides the connected piece that you click, or all but it, or gives it a curve of its own (K).</source>
        <translation>Blendet das zusammenhängende Teil aus, das angeklickt wird, oder alles andere, oder gibt ihm eine eigene Kurve (K).</translation>
    </message>
    <message>
        <source>Name of the cut</source>
        <translation>Name des Schnitts</translation>
    </message>
    <message>
        <source>%1, %2 deep</source>
        <translation>%1, %2 tief</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>What was cut away or told apart, in order; marked cuts hold. A double click or F2 names one; a piece with its own curve comes into the curve panel by a click.</source>
        <translation>Was weggeschnitten oder unterschieden wurde, der Reihe nach; angekreuzte Schnitte gelten. Ein Doppelklick oder F2 benennt einen; ein Teil mit eigener Kurve kommt durch einen Klick in den Kurvenbereich.</translation>
    </message>
    <message>
        <source>name cut %1</source>
        <translation>Schnitt %1 benennen</translation>
    </message>
</context>
<context>
    <name>limn::DialSection</name>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>Refined on screen to %1, within %2.</source>
        <translation>Am Bildschirm verfeinert auf %1, Fehler %2.</translation>
    </message>
    <message>
        <source>Faster or closer to exact</source>
        <translation>Schneller oder genauer</translation>
    </message>
    <message>
        <source>Finding the steps</source>
        <translation>Schrittweiten werden gesucht</translation>
    </message>
    <message>
        <source>Picture at rest</source>
        <translation>Bild im Stillstand</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>&lt;p&gt;How far apart the samples along a ray lie while nothing moves: to the left the picture is there sooner, to the right it is closer to the exact one; at the end samples are spent where the picture needs them to be within half a level of 255.&lt;/p&gt;&lt;p&gt;From 2 voxels to exact, default 1/2. The figures are the error of 999 in 1000 colour values, in levels of 255, and the time of a picture, both measured here.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Wie weit die Abtastpunkte eines Strahls auseinanderliegen, solange sich nichts bewegt: nach links ist das Bild früher da, nach rechts ist es näher am exakten; am Ende wird dort abgetastet, wo das Bild es braucht, um höchstens eine halbe von 255 Stufen abzuweichen.&lt;/p&gt;&lt;p&gt;Von 2 Voxeln bis exakt, Standard 1/2. Die Zahlen nennen den Fehler von 999 von 1000 Farbwerten in Stufen von 255 und die Zeit eines Bildes, beide hier gemessen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>at most %1 ms</source>
        <translation>höchstens %1&#xa0;ms</translation>
    </message>
    <message>
        <source>While moving</source>
        <translation>In Bewegung</translation>
    </message>
    <message>
        <source>How long a picture may take while you turn or drag: with less time it gets coarser and follows the hand more closely.</source>
        <translation>Wie lange ein Bild dauern darf, während Sie drehen oder ziehen: Mit weniger Zeit wird es gröber und folgt der Hand besser.</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Open a volume to choose.</source>
        <translation>Öffnen Sie ein Volumen, um zu wählen.</translation>
    </message>
    <message>
        <source>With blurred steps (jitter) no error is measured.</source>
        <translation>Bei verwischten Schritten (Jitter) wird kein Fehler gemessen.</translation>
    </message>
    <message>
        <source>%1: not measured for this picture.</source>
        <translation>%1: für dieses Bild nicht gemessen.</translation>
    </message>
    <message>
        <source>A level is the smallest step of brightness on a screen, of 255.</source>
        <translation>Eine Stufe ist der kleinste Helligkeitsschritt eines Bildschirms, von 255.</translation>
    </message>
    <message>
        <source>Physical light gets twice and twice as many paths while nothing moves. How many a saved picture has stands among the properties.</source>
        <translation>Physikalisches Licht bekommt immer doppelt so viele Pfade, solange sich nichts bewegt. Wie viele ein gespeichertes Bild hat, steht bei den Eigenschaften.</translation>
    </message>
    <message>
        <source>steps by error</source>
        <translation>Schritten nach dem Fehler</translation>
    </message>
    <message>
        <source>The picture on screen</source>
        <translation>Das Bild auf dem Schirm</translation>
    </message>
    <message>
        <source>Refined on screen to %1</source>
        <translation>Auf dem Schirm verfeinert auf %1</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>a picture: how far it is off</comment>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>It was measured from another direction.</source>
        <translation>Gemessen wurde aus einer anderen Richtung.</translation>
    </message>
    <message>
        <source>From there it refines while nothing moves.</source>
        <translation>Von dort wird es feiner, solange sich nichts bewegt.</translation>
    </message>
    <message>
        <source>Steps meant to be %1</source>
        <translation>Schritte, gedacht als %1</translation>
    </message>
    <message>
        <source>Levels and times of the steps are those of the picture before it is refined.</source>
        <translation>Stufen und Zeiten der Schritte sind die des Bildes, bevor es verfeinert wird.</translation>
    </message>
    <message>
        <source>From there it refines while nothing moves, but shadows and occlusion come from few paths or a grid of light, which smaller steps do not make finer: where they show, the picture may stay &quot;not exact&quot;. With &quot;exact&quot; the processor follows more paths, which takes some minutes.</source>
        <translation>Von dort wird es feiner, solange sich nichts bewegt; Schatten und Verdeckung aber kommen von wenigen Lichtpfaden oder einem Lichtgitter, die kleinere Schritte nicht feiner machen: Wo sie zu sehen sind, kann das Bild „nicht exakt“ bleiben. Mit „exakt“ folgt der Prozessor mehr Pfaden, was einige Minuten dauert.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <comment>a list, and the last of it</comment>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>Tissue that is thinner than a step is not missed (&quot;curve averaged&quot; in the chart).</source>
        <translation>Gewebe, das dünner ist als ein Schritt, wird nicht übersehen („Kurve gemittelt“ im Diagramm).</translation>
    </message>
    <message>
        <source>Tissue that is thinner than a step is not missed with a step of %1 (&quot;curve averaged&quot; in the chart).</source>
        <translation>Gewebe, das dünner ist als ein Schritt, wird mit einem Schritt von %1 nicht übersehen („Kurve gemittelt“ im Diagramm).</translation>
    </message>
    <message>
        <source>Rather than %1 choose a position that is both faster and closer to the exact picture.</source>
        <translation>Wählen Sie statt %1 eine Stellung, die schneller ist und näher am exakten Bild liegt.</translation>
    </message>
</context>
<context>
    <name>limn::DialogController</name>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Leitfaden</translation>
    </message>
    <message>
        <source>Opens the guide at what it says of the panel with the keyboard.</source>
        <translation>Öffnet den Leitfaden dort, wo er von dem Bereich handelt, der die Tastatur hat.</translation>
    </message>
    <message>
        <source>Mouse and &amp;keys</source>
        <translation>&amp;Maus und Tasten</translation>
    </message>
    <message>
        <source>&amp;Stability checks…</source>
        <translation>&amp;Stabilitätsprüfungen…</translation>
    </message>
    <message>
        <source>Checks what this computer&apos;s driver draws where renderers are known to fail.</source>
        <translation>Prüft, was der Treiber dieses Rechners in Fällen zeichnet, an denen Renderer bekanntermaßen scheitern.</translation>
    </message>
    <message>
        <source>&amp;About Limn</source>
        <translation>&amp;Über Limn</translation>
    </message>
</context>
<context>
    <name>limn::DicomDialog</name>
    <message>
        <source>&amp;Leave out what the series says of its patient and study</source>
        <translation>&amp;Weglassen, was die Serie über Patient und Studie sagt</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern…</translation>
    </message>
    <message>
        <source>Save to DICOM</source>
        <translation>Als DICOM speichern</translation>
    </message>
    <message>
        <source>The UIDs of study and images stay: by them the look finds its images.</source>
        <translation>Die UIDs von Studie und Bildern bleiben: An ihnen findet die Darstellung ihre Bilder.</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>Das Bild wird gezeichnet</translation>
    </message>
    <message>
        <source>Drawing the picture…</source>
        <translation>Das Bild wird gezeichnet…</translation>
    </message>
    <message>
        <source>What other programs see differently</source>
        <translation>Was andere Programme anders sehen</translation>
    </message>
    <message>
        <source>What &amp;others see differently (Limn reads all of it back, but for kept labels):</source>
        <translation>Was &amp;andere anders sehen (Limn liest alles davon zurück, nur behaltene Labels nicht):</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Abgebrochen; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Save to D&amp;ICOM…</source>
        <translation>Als D&amp;ICOM speichern…</translation>
    </message>
    <message>
        <source>Saves picture and look of a DICOM series for an archive, filed with its patient and study.</source>
        <translation>Speichert Bild und Darstellung einer DICOM-Serie für ein Archiv, bei ihrem Patienten und ihrer Studie.</translation>
    </message>
    <message>
        <source>The picture: %1, %2 × %3 pixels, without marks on it.</source>
        <translation>Das Bild: %1, %2 × %3 Pixel, ohne Beschriftung.</translation>
    </message>
    <message>
        <source>Save picture and look in a new folder</source>
        <translation>Bild und Darstellung in einem neuen Ordner speichern</translation>
    </message>
    <message>
        <source>Folder with picture.dcm and look.dcm (*.dicom)</source>
        <translation>Ordner mit picture.dcm und look.dcm (*.dicom)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 wurde gespeichert.</translation>
    </message>
    <message>
        <source>Saves files for an archive: the picture (picture.dcm), the look that it was made with (look.dcm), which other programs and Limn can open, and where something is kept by label or cut away which voxels these are (segments.dcm).</source>
        <translation>Speichert Dateien für ein Archiv: das Bild (picture.dcm), die Darstellung, mit der es entstand (look.dcm) und die andere Programme und Limn öffnen können, und, wo etwas nach Labels behalten oder weggeschnitten ist, welche Voxel das sind (segments.dcm).</translation>
    </message>
    <message>
        <source>The files name nobody. They keep the UIDs of the study and of its images, by which the look finds them.</source>
        <translation>Die Dateien nennen niemanden. Sie behalten die UIDs der Studie und ihrer Bilder, durch die die Darstellung sie findet.</translation>
    </message>
    <message>
        <source>The files carry what the series says of its patient, because an archive files them by it. Nothing else that Limn writes does.</source>
        <translation>Die Dateien enthalten, was die Serie über den Patienten sagt, weil ein Archiv sie danach ablegt. Sonst tut das nichts, was Limn schreibt.</translation>
    </message>
</context>
<context>
    <name>limn::Docks</name>
    <message>
        <source>Se&amp;parate windows</source>
        <translation>Abgel&amp;öste Fenster</translation>
    </message>
    <message>
        <source>Panels at the left</source>
        <translation>Bereiche links</translation>
    </message>
    <message>
        <source>Shows or folds the panels at the left.</source>
        <translation>Zeigt die Bereiche links oder klappt sie ein.</translation>
    </message>
    <message>
        <source>Curve below</source>
        <translation>Kurve unten</translation>
    </message>
    <message>
        <source>Shows or folds the curve.</source>
        <translation>Zeigt die Kurve oder klappt sie ein.</translation>
    </message>
    <message>
        <source>Panels at the right</source>
        <translation>Bereiche rechts</translation>
    </message>
    <message>
        <source>Shows or folds the panels at the right.</source>
        <translation>Zeigt die Bereiche rechts oder klappt sie ein.</translation>
    </message>
</context>
<context>
    <name>limn::DriverRecovery</name>
    <message>
        <source>The graphics driver failed, and everything in it was made anew; nothing is lost.</source>
        <translation>Der Grafiktreiber ist ausgefallen, und alles darin wurde neu angelegt; nichts ist verloren.</translation>
    </message>
</context>
<context>
    <name>limn::DropController</name>
    <message>
        <source>Let go to open %1</source>
        <translation>Loslassen, um %1 zu öffnen</translation>
    </message>
    <message>
        <source>Let go to open %1 files</source>
        <translation>Loslassen, um %1 Dateien zu öffnen</translation>
    </message>
</context>
<context>
    <name>limn::EarlierLook</name>
    <message>
        <source>Earlier look</source>
        <translation>Vorige Darstellung</translation>
    </message>
    <message>
        <source>use the look of the volume before</source>
        <translation>Darstellung des vorigen Volumens verwenden</translation>
    </message>
    <message>
        <source>The look of the volume before was fitted to the values of this one: not both are in Hounsfield units.</source>
        <translation>Die Darstellung des vorigen Volumens wurde an die Werte dieses Volumens angepasst: Nicht beide sind in Hounsfield-Einheiten.</translation>
    </message>
    <message>
        <source>Use the &amp;look of the volume before</source>
        <translation>Dars&amp;tellung des vorigen Volumens verwenden</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Strg+L</translation>
    </message>
    <message>
        <source>Shows this volume with curve and light of the one that was open before it.</source>
        <translation>Zeigt dieses Volumen mit Kurve und Licht des zuvor geöffneten.</translation>
    </message>
</context>
<context>
    <name>limn::EffectRowWidget</name>
    <message>
        <source>The picture takes %1 ms %2 with this effect; repeated measurements scatter by ±%3 ms.</source>
        <translation>Das Bild dauert mit diesem Effekt %1&#xa0;ms %2; wiederholte Messungen streuen um ±%3&#xa0;ms.</translation>
    </message>
    <message>
        <source>less</source>
        <translation>weniger</translation>
    </message>
    <message>
        <source>more</source>
        <translation>mehr</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Leaves this effect out of the picture.</source>
        <translation>Lässt diesen Effekt im Bild weg.</translation>
    </message>
    <message>
        <source>Has the picture show it.</source>
        <translation>Lässt das Bild es zeigen.</translation>
    </message>
    <message>
        <source>%1; it %2.</source>
        <translation>%1; dies %2.</translation>
    </message>
    <message>
        <source>%1; switched on it %2, and %3.</source>
        <translation>%1; eingeschaltet: %2 und %3.</translation>
    </message>
    <message>
        <source>%1; switched on it %2.</source>
        <translation>%1; eingeschaltet: %2.</translation>
    </message>
</context>
<context>
    <name>limn::EffectsPanel</name>
    <message>
        <source>Effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>Open a volume to see which effects its picture calls for.</source>
        <translation>Öffnen Sie ein Volumen, um zu sehen, welche Effekte sein Bild braucht.</translation>
    </message>
    <message>
        <source>%1: the picture calls for %2 of %3 effects; nothing else is computed.</source>
        <translation>%1: Das Bild braucht %2 von %3 Effekten; anderes wird nicht berechnet.</translation>
    </message>
    <message>
        <source>Measuring… %1 %</source>
        <translation>Messung… %1&#xa0;%</translation>
    </message>
    <message>
        <source>Measure cost</source>
        <translation>Kosten messen</translation>
    </message>
    <message>
        <source>The whole picture takes %1 ms at %2 × %3 pixels. Each cost is the median time with the effect less the median without it; costs overlap and do not add up. Method: %4.</source>
        <translation>Das ganze Bild dauert %1&#xa0;ms bei %2 × %3 Pixeln. Jeder Kostenwert ist der Median der Zeit mit dem Effekt abzüglich des Medians ohne ihn; Kosten überschneiden sich und addieren sich nicht. Verfahren: %4.</translation>
    </message>
    <message>
        <source>Draws the picture several times with and without each effect, also with those that are off, while nothing else is to be drawn; any change of the scene stops it.</source>
        <translation>Zeichnet das Bild mehrmals mit und ohne jeden Effekt, auch mit den ausgeschalteten, solange nichts anderes zu zeichnen ist; jede Änderung der Szene beendet es.</translation>
    </message>
    <message>
        <source>Measuring what effects cost</source>
        <translation>Kosten der Effekte werden gemessen</translation>
    </message>
</context>
<context>
    <name>limn::EmphasisController</name>
    <message>
        <source>in green what the point at %1 governs</source>
        <translation>in Grün, was der Punkt bei %1 bestimmt</translation>
    </message>
</context>
<context>
    <name>limn::EmptyPanel</name>
    <message>
        <source>Drop a DICOM folder or a volume file here</source>
        <translation>DICOM-Ordner oder Volumendatei hierher ziehen</translation>
    </message>
    <message>
        <source>DICOM · NIfTI · NRRD · MetaImage · VTK · TIFF, PNG and JPEG stacks</source>
        <translation>DICOM · NIfTI · NRRD · MetaImage · VTK · Stapel aus TIFF, PNG und JPEG</translation>
    </message>
    <message>
        <source>Open DICOM folder…</source>
        <translation>DICOM-Ordner öffnen…</translation>
    </message>
    <message>
        <source>Open file…</source>
        <translation>Datei öffnen…</translation>
    </message>
    <message>
        <source>Try the sample head</source>
        <translation>Beispielkopf ausprobieren</translation>
    </message>
    <message>
        <source>Opened before</source>
        <translation>Zuvor geöffnet</translation>
    </message>
    <message>
        <source>Open again: %1</source>
        <translation>Wieder öffnen: %1</translation>
    </message>
    <message>
        <source>Unsaved work:
%1</source>
        <translation>Nicht gespeicherte Arbeit:
%1</translation>
    </message>
    <message>
        <source>Unsaved work: %1</source>
        <translation>Nicht gespeicherte Arbeit: %1</translation>
    </message>
    <message>
        <source>Limn shows CT and MR volumes in three dimensions.</source>
        <translation>Limn zeigt CT- und MR-Volumen dreidimensional.</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Aus dieser Liste entfernen</translation>
    </message>
</context>
<context>
    <name>limn::EngineController</name>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>processor</source>
        <translation>Prozessor</translation>
    </message>
    <message>
        <source>&amp;Automatic: %1</source>
        <translation>&amp;Automatisch: %1</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatisch</translation>
    </message>
    <message>
        <source>Draws with the engine that is faster on this computer.</source>
        <translation>Zeichnet mit der Engine, die auf diesem Rechner schneller ist.</translation>
    </message>
    <message>
        <source>&amp;OpenGL</source>
        <translation>&amp;OpenGL</translation>
    </message>
    <message>
        <source>&amp;OpenGL (not on this computer)</source>
        <translation>&amp;OpenGL (nicht auf diesem Rechner)</translation>
    </message>
    <message>
        <source>&amp;Processor</source>
        <translation>&amp;Prozessor</translation>
    </message>
    <message>
        <source>Draws with the vector instructions of the processor; needs no graphics card.</source>
        <translation>Zeichnet mit den Vektorbefehlen des Prozessors; braucht keine Grafikkarte.</translation>
    </message>
    <message>
        <source>Draw with</source>
        <translation>Zeichnen mit</translation>
    </message>
</context>
<context>
    <name>limn::EngineSwitch</name>
    <message>
        <source>The graphics driver gives this window no OpenGL context; restart the program.</source>
        <translation>Der Grafiktreiber gibt diesem Fenster keinen OpenGL-Kontext; starten Sie das Programm neu.</translation>
    </message>
    <message>
        <source>Getting the volume ready for drawing was cancelled.</source>
        <translation>Die Vorbereitung des Volumens zum Zeichnen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 The processor draws it.</source>
        <translation>%1 Der Prozessor zeichnet es.</translation>
    </message>
</context>
<context>
    <name>limn::ErrorMapOverlay</name>
    <message>
        <source>%1 and more</source>
        <translation>%1 und mehr</translation>
    </message>
    <message>
        <source>Error, levels of 255</source>
        <translation>Fehler, Stufen von 255</translation>
    </message>
    <message>
        <source>Map of errors over the picture</source>
        <translation>Karte der Fehler über dem Bild</translation>
    </message>
</context>
<context>
    <name>limn::ExportDialog</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>limn::FailureBar</name>
    <message>
        <source>Copy details</source>
        <translation>Einzelheiten kopieren</translation>
    </message>
    <message>
        <source>What the driver wrote, for a report; it names nobody and no file</source>
        <translation>Was der Treiber geschrieben hat, für eine Meldung; nennt weder Personen noch Dateien</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>%1 Until it works again, the processor draws the picture.</source>
        <translation>%1 Bis das behoben ist, zeichnet der Prozessor das Bild.</translation>
    </message>
</context>
<context>
    <name>limn::FigureDialog</name>
    <message>
        <source>As exact as a screen shows</source>
        <translation>So genau, wie ein Bildschirm es zeigt</translation>
    </message>
    <message>
        <source>Save a figure</source>
        <translation>Abbildung speichern</translation>
    </message>
    <message>
        <source>Draws within half a level of 255 of the exact picture, which takes longer than the window&apos;s own steps.</source>
        <translation>Zeichnet mit höchstens einer halben von 255 Stufen Fehler, was länger dauert als mit der Schrittweite des Fensters.</translation>
    </message>
    <message>
        <source>Making the figure</source>
        <translation>Abbildung wird erstellt</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern…</translation>
    </message>
    <message>
        <source>Copies the figure to the clipboard, in full size.</source>
        <translation>Kopiert die Abbildung in voller Größe in die Zwischenablage.</translation>
    </message>
    <message>
        <source>Cancelled; nothing was saved.</source>
        <translation>Abgebrochen; nichts wurde gespeichert.</translation>
    </message>
    <message>
        <source>Save &amp;figure…</source>
        <translation>Abbildu&amp;ng speichern…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Makes a figure to publish: pictures with names, scale, curve and notes, as PNG, TIFF, EXR or PDF.</source>
        <translation>Erstellt eine Abbildung zum Veröffentlichen: Bilder mit Namen, Maßstab, Kurve und Hinweisen, als PNG, TIFF, EXR oder PDF.</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, %3 × %4 cm; each picture %5 × %6.</source>
        <translation>%1 × %2 Pixel, %3 × %4&#xa0;cm; jedes Bild %5 × %6.</translation>
    </message>
    <message>
        <source>Save the figure</source>
        <translation>Abbildung speichern</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>PDF with text as text (*.pdf)</source>
        <translation>PDF mit Text als Text (*.pdf)</translation>
    </message>
    <message>
        <source>TIFF picture (*.tif)</source>
        <translation>TIFF-Bild (*.tif)</translation>
    </message>
    <message>
        <source>OpenEXR with floats (*.exr)</source>
        <translation>OpenEXR mit Gleitkommazahlen (*.exr)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 wurde gespeichert.</translation>
    </message>
    <message>
        <source>Copied %1 × %2 pixels.</source>
        <translation>%1 × %2 Pixel wurden kopiert.</translation>
    </message>
    <message>
        <source>Drawing the figure: %1 %</source>
        <translation>Abbildung wird gezeichnet: %1&#xa0;%</translation>
    </message>
    <message>
        <source>Drawing the preview: %1 %</source>
        <translation>Vorschau wird gezeichnet: %1&#xa0;%</translation>
    </message>
    <message>
        <source>Drawing the preview…</source>
        <translation>Vorschau wird gezeichnet…</translation>
    </message>
</context>
<context>
    <name>limn::FigureOptions</name>
    <message>
        <source>Letters a, b, …</source>
        <translation>Buchstaben a, b, …</translation>
    </message>
    <message>
        <source>Names and light</source>
        <translation>Namen und Licht</translation>
    </message>
    <message>
        <source>Sides of the patient</source>
        <translation>Seiten des Patienten</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Maßstabsbalken</translation>
    </message>
    <message>
        <source>Curve and colours</source>
        <translation>Kurve und Farben</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>What is hidden</source>
        <translation>Was ausgeblendet ist</translation>
    </message>
    <message>
        <source>“Not for diagnosis”</source>
        <translation>„Nicht zur Diagnose“</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Transparent, pictures too</source>
        <translation>Transparent, auch die Bilder</translation>
    </message>
    <message>
        <source>P&amp;age</source>
        <translation>Hinter&amp;grund</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Unit of the size</source>
        <translation>Einheit der Größe</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>A fixed height</source>
        <translation>Feste Höhe</translation>
    </message>
    <message>
        <source>Without a fixed height, the figure is as high as its pictures ask.</source>
        <translation>Ohne feste Höhe ist die Abbildung so hoch, wie ihre Bilder es verlangen.</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation>&#xa0;dpi</translation>
    </message>
    <message>
        <source>&amp;Resolution</source>
        <translation>&amp;Auflösung</translation>
    </message>
    <message>
        <source>Height of the text</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source> pt</source>
        <translation>&#xa0;pt</translation>
    </message>
    <message>
        <source>&amp;Text</source>
        <translation>&amp;Text</translation>
    </message>
    <message>
        <source>Labels and colours</source>
        <translation>Labels und Farben</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
</context>
<context>
    <name>limn::FigurePreview</name>
    <message>
        <source>Preview of the figure</source>
        <translation>Vorschau der Abbildung</translation>
    </message>
</context>
<context>
    <name>limn::Files</name>
    <message>
        <source>&amp;Close volume</source>
        <translation>&amp;Volumen schließen</translation>
    </message>
    <message>
        <source>Still drawing</source>
        <translation>Es wird noch gezeichnet</translation>
    </message>
    <message>
        <source>A file is not finished yet. If Limn ends now, it will not be.</source>
        <translation>Eine Datei ist noch nicht fertig. Wird Limn jetzt beendet, wird sie es nicht mehr.</translation>
    </message>
    <message>
        <source>Let it finish</source>
        <translation>Fertig werden lassen</translation>
    </message>
    <message>
        <source>End all the same</source>
        <translation>Trotzdem beenden</translation>
    </message>
    <message>
        <source>A drawn picture could not be written to its file. If Limn ends now, it is lost.</source>
        <translation>Ein gezeichnetes Bild konnte nicht in seine Datei geschrieben werden. Endet Limn jetzt, ist es verloren.</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>Noch nicht gespeichert</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Behalten</translation>
    </message>
</context>
<context>
    <name>limn::FocusMode</name>
    <message>
        <source>F11 or Esc shows the panels again</source>
        <translation>F11 oder Esc zeigt die Bereiche wieder</translation>
    </message>
    <message>
        <source>Picture without panels and cur&amp;ve</source>
        <translation>N&amp;ur das Bild</translation>
    </message>
</context>
<context>
    <name>limn::FogSection</name>
    <message>
        <source>Density (ρ)</source>
        <translation>Dichte (ρ)</translation>
    </message>
    <message>
        <source>How fast the picture fades with distance: more is thicker, 0 is no fog.</source>
        <translation>Wie schnell das Bild mit der Entfernung verblasst: mehr ist dichter, 0 ist kein Nebel.</translation>
    </message>
    <message>
        <source>per mm</source>
        <translation>je mm</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Begins at</source>
        <translation>Beginnt bei</translation>
    </message>
    <message>
        <source>The distance from the viewer up to which the picture stays clear; zooming out moves the viewer away.</source>
        <translation>Die Entfernung vom Betrachter, bis zu der das Bild klar bleibt; Herauszoomen entfernt den Betrachter.</translation>
    </message>
    <message>
        <source>Full at</source>
        <translation>Voll bei</translation>
    </message>
    <message>
        <source>The distance from the viewer from which only the fog&apos;s colour is left.</source>
        <translation>Die Entfernung vom Betrachter, ab der nur noch die Farbe des Nebels bleibt.</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>How the picture fades to the fog&apos;s colour with the distance from the eye.</source>
        <translation>Wie das Bild mit der Entfernung vom Auge in die Farbe des Nebels übergeht.</translation>
    </message>
    <message>
        <source>Evenly (linear)</source>
        <translation>Gleichmäßig (linear)</translation>
    </message>
    <message>
        <source>Gradually (exp)</source>
        <translation>Allmählich (exp)</translation>
    </message>
    <message>
        <source>Late, then fast (exp2)</source>
        <translation>Spät, dann schnell (exp2)</translation>
    </message>
    <message>
        <source>change colour of fog</source>
        <translation>Farbe des Nebels ändern</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour of the fog</source>
        <translation>Farbe des Nebels</translation>
    </message>
    <message>
        <source>&lt;p&gt;The colour to which the distance fades; the background&apos;s own looks deepest.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Die Farbe, in die die Ferne übergeht; die des Hintergrunds wirkt am tiefsten.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>unused: this projection has no depth</source>
        <translation>Projektion ohne Tiefe</translation>
    </message>
    <message>
        <source>off: its density is 0</source>
        <translation>aus: Dichte ist 0</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Nebelart</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Density of the fog</source>
        <translation>Dichte des Nebels</translation>
    </message>
    <message>
        <source>Beginning of the fog</source>
        <translation>Beginn des Nebels</translation>
    </message>
    <message>
        <source>Distance of the full fog</source>
        <translation>Entfernung des vollen Nebels</translation>
    </message>
</context>
<context>
    <name>limn::FoldingHeader</name>
    <message>
        <source>Fold or unfold &quot;%1&quot;</source>
        <translation>„%1“ auf- oder zuklappen</translation>
    </message>
</context>
<context>
    <name>limn::Frame</name>
    <message>
        <source>&amp;Quit</source>
        <translation>Be&amp;enden</translation>
    </message>
    <message>
        <source>Follow the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>The window speaks it at once.</source>
        <translation>Das Fenster verwendet sie sofort.</translation>
    </message>
    <message>
        <source>The window speaks this language as soon as nothing is being read, written or measured, no measurement, line or piece is unfinished, no other dialog is open and no picture waits to be saved elsewhere.</source>
        <translation>Das Fenster verwendet diese Sprache, sobald nichts gelesen, geschrieben oder gemessen wird, keine Messung, keine Linie und kein Stück unfertig ist, kein anderer Dialog offen ist und kein Bild darauf wartet, anderswo gespeichert zu werden.</translation>
    </message>
</context>
<context>
    <name>limn::GradientOpacityEditor</name>
    <message>
        <source>Use this curve</source>
        <translation>Diese Kurve verwenden</translation>
    </message>
    <message>
        <source>Use the curve of opacity over the gradient</source>
        <translation>Kurve der Deckkraft über dem Gradienten verwenden</translation>
    </message>
    <message>
        <source>&lt;p&gt;Multiplies the opacity by this curve, so that boundaries stay and even tissue fades.&lt;/p&gt;&lt;p&gt;On or off, default off.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Multipliziert die Deckkraft mit dieser Kurve, sodass Grenzflächen bleiben und homogenes Gewebe verblasst.&lt;/p&gt;&lt;p&gt;An oder aus, Standard aus.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>per mm</source>
        <translation>je mm</translation>
    </message>
    <message>
        <source>%1/mm</source>
        <translation>%1/mm</translation>
    </message>
    <message>
        <source>use opacity over gradient</source>
        <translation>Deckkraft über dem Gradienten verwenden</translation>
    </message>
    <message>
        <source>drop opacity over gradient</source>
        <translation>Deckkraft über dem Gradienten weglassen</translation>
    </message>
    <message>
        <source>Off: opacity follows the value alone. Tick &quot;Use this curve&quot; to keep boundaries and fade even tissue.</source>
        <translation>Aus: Die Deckkraft folgt allein dem Wert. Mit „Diese Kurve verwenden“ bleiben Grenzflächen, und homogenes Gewebe verblasst.</translation>
    </message>
    <message>
        <source>Counting the volume&apos;s gradients…</source>
        <translation>Gradienten des Volumens werden gezählt…</translation>
    </message>
</context>
<context>
    <name>limn::GradientSection</name>
    <message>
        <source>Percentile</source>
        <translation>Perzentil</translation>
    </message>
    <message>
        <source>Boundaries stronger than this share of all voxels count as strongest; lower it when metal makes everything else look flat.</source>
        <translation>Grenzflächen, die stärker sind als dieser Anteil aller Voxel, gelten als die stärksten; verkleinern Sie ihn, wenn Metall alles andere flach wirken lässt.</translation>
    </message>
    <message>
        <source>Strongest boundary</source>
        <translation>Stärkste Grenzfläche</translation>
    </message>
    <message>
        <source>The change of value per millimetre that counts as the strongest boundary; smaller numbers emphasise weaker boundaries.</source>
        <translation>Die Änderung des Werts je Millimeter, die als stärkste Grenzfläche gilt; kleinere Zahlen betonen schwächere Grenzflächen.</translation>
    </message>
    <message>
        <source>per mm</source>
        <translation>je mm</translation>
    </message>
    <message>
        <source>How strongly the curve bends: the exponent of the gamma curve, the base of the logarithmic one.</source>
        <translation>Wie stark die Kurve gebogen ist: der Exponent der Gammakurve, die Basis der logarithmischen.</translation>
    </message>
    <message>
        <source>Highlights begin at</source>
        <translation>Glanzlichtschwelle</translation>
    </message>
    <message>
        <source>Highlights fade in between these shares of the strongest boundary, so that noise in flat tissue does not sparkle.</source>
        <translation>Zwischen diesen Anteilen der stärksten Grenzfläche werden Glanzlichter eingeblendet, damit Rauschen in homogenem Gewebe nicht funkelt.</translation>
    </message>
    <message>
        <source>Soft limit from (k)</source>
        <translation>Weiche Grenze ab (k)</translation>
    </message>
    <message>
        <source>The brightness above which colours are held back smoothly; lower numbers keep more hue in highlights.</source>
        <translation>Die Helligkeit, ab der Farben sanft begrenzt werden; kleinere Zahlen erhalten mehr Farbton in Glanzlichtern.</translation>
    </message>
    <message>
        <source>Boundaries</source>
        <translation>Grenzflächen</translation>
    </message>
    <message>
        <source>unused: not in this model</source>
        <translation>nicht in diesem Modell</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>How boundary strength is weighed; gamma below 1 and logarithmic lift weak boundaries.</source>
        <translation>Wie die Stärke einer Grenzfläche gewichtet wird; Gamma unter 1 und logarithmisch heben schwache Grenzflächen an.</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>&lt;p&gt;Dims broad highlights so that sharp and broad ones carry the same light.&lt;/p&gt;&lt;p&gt;On or off, default on.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Dämpft breite Glanzlichter, sodass scharfe und breite gleich viel Licht tragen.&lt;/p&gt;&lt;p&gt;An oder aus, Standard an.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Keeps highlights to clear boundaries, so that noise does not sparkle.&lt;/p&gt;&lt;p&gt;On or off, default on.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Beschränkt Glanzlichter auf deutliche Grenzflächen, damit Rauschen nicht funkelt.&lt;/p&gt;&lt;p&gt;An oder aus, Standard an.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Highlights only at boundaries</source>
        <translation>Glanzlichter nur an Grenzflächen</translation>
    </message>
    <message>
        <source>&lt;p&gt;Holds bright colours back smoothly instead of clipping them to white.&lt;/p&gt;&lt;p&gt;On or off, default on.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Begrenzt helle Farben sanft, statt sie zu Weiß abzuschneiden.&lt;/p&gt;&lt;p&gt;An oder aus, Standard an.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Soft limit for brightness</source>
        <translation>Weiche Grenze der Helligkeit</translation>
    </message>
    <message>
        <source>Only the robust model does this, and it is not shown.</source>
        <translation>Das tut nur das Modell „Robust“, und es wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>Switch the line above on first.</source>
        <translation>Schalten Sie zuerst die Zeile darüber ein.</translation>
    </message>
    <message>
        <source>At a change of</source>
        <translation>Wertänderung</translation>
    </message>
    <message>
        <source>Strength of it</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Full effect at</source>
        <translation>Volle Wirkung bei</translation>
    </message>
    <message>
        <source>Weighting</source>
        <translation>Gewichtung</translation>
    </message>
    <message>
        <source>Dim broad highlights</source>
        <translation>Breite Glanzlichter dämpfen</translation>
    </message>
    <message>
        <source>Which boundary counts as the strongest; &quot;automatic&quot; is the largest for enhanced and the 99.5th percentile for robust and physical.</source>
        <translation>Welche Grenze als die stärkste gilt; „automatisch“ ist die größte bei „verstärkt“ und das 99,5. Perzentil bei „robust“ und „physikalisch“.</translation>
    </message>
    <message>
        <source>Highlights and limits</source>
        <translation>Glanzlichter und Grenzen</translation>
    </message>
    <message>
        <source>Only the robust and physical models do this, and none is shown.</source>
        <translation>Das tun nur die Modelle „robust“ und „physikalisch“, und keines wird gezeigt.</translation>
    </message>
    <message>
        <source>Only the enhanced, robust and physical models follow boundaries, and none is shown.</source>
        <translation>Nur die Modelle „verstärkt“, „robust“ und „physikalisch“ folgen Grenzen, und keines wird gezeigt.</translation>
    </message>
    <message>
        <source>Percentile of the full effect</source>
        <translation>Perzentil der vollen Wirkung</translation>
    </message>
    <message>
        <source>Gradient of the full effect</source>
        <translation>Gradient der vollen Wirkung</translation>
    </message>
    <message>
        <source>Strength of the gradient curve</source>
        <translation>Stärke der Gradientenkurve</translation>
    </message>
    <message>
        <source>Boundaries with highlights</source>
        <translation>Grenzen mit Glanzlichtern</translation>
    </message>
    <message>
        <source>Soft limit (k)</source>
        <translation>Weiche Grenze (k)</translation>
    </message>
</context>
<context>
    <name>limn::GuideView</name>
    <message>
        <source>Guide</source>
        <translation>Leitfaden</translation>
    </message>
</context>
<context>
    <name>limn::GuideWindow</name>
    <message>
        <source>Limn: the guide</source>
        <translation>Limn: der Leitfaden</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Find in the guide (Ctrl+F)</source>
        <translation>Im Leitfaden suchen (Strg+F)</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>Im Leitfaden suchen</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Vorherige</translation>
    </message>
    <message>
        <source>The place before (Shift+F3)</source>
        <translation>Die Stelle davor (Umschalt+F3)</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>The next place (F3, Enter)</source>
        <translation>Die nächste Stelle (F3, Eingabe)</translation>
    </message>
    <message>
        <source>The guide is written in English.</source>
        <translation>Der Leitfaden ist englisch.</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>To where the link was followed (Alt+Left)</source>
        <translation>Dorthin, wo dem Link gefolgt wurde (Alt+Links)</translation>
    </message>
</context>
<context>
    <name>limn::HintBar</name>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Lays the tool aside (Esc).</source>
        <translation>Legt das Werkzeug weg (Esc).</translation>
    </message>
</context>
<context>
    <name>limn::HistogramButton</name>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>As high as the number of voxels: large tissues stand out.</source>
        <translation>So hoch wie die Zahl der Voxel: Große Gewebe treten hervor.</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>By the logarithm of the number of voxels: small tissues show beside large ones.</source>
        <translation>Nach dem Logarithmus der Voxelzahl: Kleine Gewebe sind neben großen zu sehen.</translation>
    </message>
    <message>
        <source>Percentile</source>
        <translation>Perzentil</translation>
    </message>
    <message>
        <source>How many of the voxels lie at or below a value: 0 at the left, all of them at the right.</source>
        <translation>Wie viele der Voxel bei einem Wert oder darunter liegen: links 0, rechts alle.</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>The whole volume</source>
        <translation>Ganzes Volumen</translation>
    </message>
    <message>
        <source>Every voxel counts.</source>
        <translation>Jedes Voxel zählt.</translation>
    </message>
    <message>
        <source>What is kept</source>
        <translation>Was behalten wird</translation>
    </message>
    <message>
        <source>Voxels count that neither the crop box nor the kept region (body, labels) hides.</source>
        <translation>Es zählen Voxel, die weder die Zuschnittbox noch der behaltene Bereich (Körper, Labels) ausblendet.</translation>
    </message>
    <message>
        <source>What is visible</source>
        <translation>Was sichtbar ist</translation>
    </message>
    <message>
        <source>Of what is kept, voxels count to whose value the curve gives opacity, even where others hide them from the camera.</source>
        <translation>Von dem, was behalten wird, zählen Voxel, deren Wert die Kurve Deckkraft gibt, auch wenn andere sie vor der Kamera verdecken.</translation>
    </message>
    <message>
        <source>Histogram: %1</source>
        <translation>Histogramm: %1</translation>
    </message>
    <message>
        <source>&lt;p&gt;What stands behind the curve: %1.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Was hinter der Kurve steht: %1.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>limn::HistogramController</name>
    <message>
        <source>The voxels that are kept cannot be counted: %1.</source>
        <translation>Die behaltenen Voxel können nicht gezählt werden: %1.</translation>
    </message>
</context>
<context>
    <name>limn::LabelSection</name>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Open labels…</source>
        <translation>Labels öffnen…</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Opens a segmentation of the volume: DICOM SEG, NRRD, NIfTI.</source>
        <translation>Öffnet eine Segmentierung des Volumens: DICOM SEG, NRRD, NIfTI.</translation>
    </message>
    <message>
        <source>Shows every label wholly again.</source>
        <translation>Zeigt jedes Label wieder ganz.</translation>
    </message>
    <message>
        <source>%1 shown</source>
        <translation>%1 gezeigt</translation>
    </message>
    <message>
        <source>%1 of %2 hidden or faded</source>
        <translation>%1 von %2 ausgeblendet oder abgeschwächt</translation>
    </message>
    <message>
        <source>Search labels</source>
        <translation>Labels suchen</translation>
    </message>
    <message>
        <source>Marked labels are shown; a number says how much of its opacity one keeps. One with its own curve comes into the curve panel by a click.</source>
        <translation>Angekreuzte Labels werden gezeigt; eine Zahl sagt, wie viel seiner Deckkraft eines behält. Eines mit eigener Kurve kommt durch einen Klick in den Kurvenbereich.</translation>
    </message>
    <message>
        <source>Shows only labels whose name holds these words</source>
        <translation>Zeigt nur Labels, deren Name diese Wörter enthält</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Show only this</source>
        <translation>Nur dies zeigen</translation>
    </message>
</context>
<context>
    <name>limn::LabelTable</name>
    <message>
        <source>hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>fade %1 to %2 %</source>
        <translation>%1 auf %2&#xa0;% abschwächen</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>%1 shown to %2 %</source>
        <translation>%1 zu %2&#xa0;% gezeigt</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>own</source>
        <translation>eigene</translation>
    </message>
    <message>
        <source>Whether %1 has a curve of its own, in place of the one for all tissue.</source>
        <translation>Ob %1 eine eigene Kurve hat statt der für alles Gewebe.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>give %1 its own curve</source>
        <translation>%1 eine eigene Kurve geben</translation>
    </message>
    <message>
        <source>give %1 the curve of all tissue</source>
        <translation>%1 die Kurve für alles Gewebe geben</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>%1 (label %2): shown, hidden, or faded where only a part of its opacity is kept. A click on its square gives it a colour.</source>
        <translation>%1 (Label %2): gezeigt, ausgeblendet oder abgeschwächt, wenn nur ein Teil seiner Deckkraft bleibt. Ein Klick auf sein Farbfeld gibt ihm eine Farbe.</translation>
    </message>
    <message>
        <source>colour of %1</source>
        <translation>Farbe von %1</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 – %4</source>
        <translation>%1 · %2 · %3 – %4</translation>
    </message>
    <message>
        <source>It has no voxels of its own, so there is nothing to show: labels read after it cover it.</source>
        <translation>Es hat keine eigenen Voxel, daher gibt es nichts zu zeigen: Labels, die nach ihm gelesen wurden, bedecken es.</translation>
    </message>
    <message>
        <source>show only %1</source>
        <translation>nur %1 zeigen</translation>
    </message>
    <message>
        <source>show all labels</source>
        <translation>alle Labels zeigen</translation>
    </message>
</context>
<context>
    <name>limn::LabelTree</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 labels whose names begin with &quot;%2&quot;: a click on the mark shows or hides all of them.</source>
        <translation>%1 Labels, deren Namen mit „%2“ beginnen: Ein Klick auf das Kästchen zeigt oder verbirgt sie alle.</translation>
    </message>
    <message>
        <source>%1 labels that their file counts as &quot;%2&quot;: a click on the mark shows or hides all of them.</source>
        <translation>%1 Labels, die ihre Datei zu „%2“ zählt: Ein Klick auf das Kästchen zeigt oder verbirgt sie alle.</translation>
    </message>
</context>
<context>
    <name>limn::LightBall</name>
    <message>
        <source>Lamp</source>
        <translation>Lampe</translation>
    </message>
    <message>
        <source>&lt;p&gt;Drag the lamp to where light is to come from; arrow keys move it, too.&lt;/p&gt;&lt;p&gt;Double click puts it before the viewer.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Ziehen Sie die Lampe dahin, woher das Licht kommen soll; auch Pfeiltasten bewegen sie.&lt;/p&gt;&lt;p&gt;Ein Doppelklick stellt sie vor den Betrachter.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>move the lamp</source>
        <translation>Lampe bewegen</translation>
    </message>
</context>
<context>
    <name>limn::LightSection</name>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>unused: this model is unlit</source>
        <translation>Modell ohne Licht</translation>
    </message>
    <message>
        <source>Ambient (ka)</source>
        <translation>Umgebung (ka)</translation>
    </message>
    <message>
        <source>How much of the light from everywhere tissue gives back: it lifts the shadows.</source>
        <translation>Wie viel vom Licht aus allen Richtungen Gewebe reflektiert: hellt die Schatten auf.</translation>
    </message>
    <message>
        <source>Diffuse (kd)</source>
        <translation>Diffus (kd)</translation>
    </message>
    <message>
        <source>How strongly surfaces that face the light brighten: it shapes the form.</source>
        <translation>Wie stark Flächen, die dem Licht zugewandt sind, heller werden: zeichnet die Form.</translation>
    </message>
    <message>
        <source>Highlights (ks)</source>
        <translation>Glanzlichter (ks)</translation>
    </message>
    <message>
        <source>How bright the highlights are; 0 makes every surface dull.</source>
        <translation>Wie hell die Glanzlichter sind; 0 macht jede Oberfläche matt.</translation>
    </message>
    <message>
        <source>The light that comes from everywhere and casts no form.</source>
        <translation>Das Licht, das aus allen Richtungen kommt und keine Form zeichnet.</translation>
    </message>
    <message>
        <source>The strength of the lamp that makes form and highlights.</source>
        <translation>Die Stärke der Lampe, die Form und Glanzlichter zeichnet.</translation>
    </message>
    <message>
        <source>Lamp position</source>
        <translation>Lampenposition</translation>
    </message>
    <message>
        <source>With the viewer</source>
        <translation>Beim Betrachter</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Lamp around</source>
        <translation>Lampenrichtung</translation>
    </message>
    <message>
        <source>Lamp height</source>
        <translation>Lampenhöhe</translation>
    </message>
    <message>
        <source>Highlight formula</source>
        <translation>Glanzlichtformel</translation>
    </message>
    <message>
        <source>How a highlight&apos;s shape follows from lamp and viewer.</source>
        <translation>Wie die Form eines Glanzlichts aus Lampe und Betrachter folgt.</translation>
    </message>
    <message>
        <source>Blinn-Phong</source>
        <translation>Blinn-Phong</translation>
    </message>
    <message>
        <source>Phong</source>
        <translation>Phong</translation>
    </message>
    <message>
        <source>Highlight colour</source>
        <translation>Glanzlichtfarbe</translation>
    </message>
    <message>
        <source>Whether highlights take the tissue&apos;s colour or are white.</source>
        <translation>Ob Glanzlichter die Farbe des Gewebes annehmen oder weiß sind.</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>&lt;p&gt;Lights the far side of thin walls too, so that cut or hollow parts do not turn black.&lt;/p&gt;&lt;p&gt;On or off, default off.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Beleuchtet auch die Rückseite dünner Wände, sodass Angeschnittenes oder Hohles nicht schwarz wird.&lt;/p&gt;&lt;p&gt;An oder aus, Standard aus.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Light both sides</source>
        <translation>Beide Seiten beleuchten</translation>
    </message>
    <message>
        <source>The unlit model uses no light.</source>
        <translation>Das unbeleuchtete Modell verwendet kein Licht.</translation>
    </message>
    <message>
        <source>Tissue reflects</source>
        <translation>Gewebe reflektiert</translation>
    </message>
    <message>
        <source>Strength of the light</source>
        <translation>Licht kommt</translation>
    </message>
    <message>
        <source>From all sides (Ia)</source>
        <translation>Von allen Seiten (Ia)</translation>
    </message>
    <message>
        <source>From the lamp (Id)</source>
        <translation>Von der Lampe (Id)</translation>
    </message>
    <message>
        <source>Smooth normals</source>
        <translation>Geglättete Normalen</translation>
    </message>
    <message>
        <source>Takes the terraces of thick slices out of the light; about 0.7 of the distance between slices is a good start. No surface moves.</source>
        <translation>Nimmt die Absätze dicker Schichten aus dem Licht; etwa das 0,7-Fache des Schichtabstands ist ein guter Anfang. Keine Oberfläche verschiebt sich.</translation>
    </message>
    <message>
        <source>A whole light in one go; the picture keeps its brightness.</source>
        <translation>Ein ganzes Licht auf einmal; das Bild behält seine Helligkeit.</translation>
    </message>
    <message>
        <source>Headlight</source>
        <translation>Vom Betrachter</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>Soft studio</source>
        <translation>Weiches Studio</translation>
    </message>
    <message>
        <source>Overcast</source>
        <translation>Bedeckter Himmel</translation>
    </message>
    <message>
        <source>My own</source>
        <translation>Eigenes</translation>
    </message>
    <message>
        <source>Whether the lamp is where the viewer is, turns with the view, so that shadows fall alike from every side, or stays with the patient.</source>
        <translation>Ob die Lampe beim Betrachter ist, sich mit der Ansicht dreht, sodass Schatten von jeder Seite gleich fallen, oder beim Patienten bleibt.</translation>
    </message>
    <message>
        <source>Turns with the view</source>
        <translation>Dreht sich mit der Ansicht</translation>
    </message>
    <message>
        <source>Where the lamp stands around the patient: 0° in front, 90° at the patient&apos;s left, −90° at the right; of a lamp that turns with the view: 0° at the viewer, 90° to the right.</source>
        <translation>Wo die Lampe um den Patienten steht: 0° vorn, 90° links vom Patienten, −90° rechts; bei einer Lampe, die sich mit der Ansicht dreht: 0° beim Betrachter, 90° rechts.</translation>
    </message>
    <message>
        <source>How high the lamp stands: 90° above, −90° below.</source>
        <translation>Wie hoch die Lampe steht: 90° oben, −90° unten.</translation>
    </message>
    <message>
        <source>What stands in the way</source>
        <translation>Was im Weg steht</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>How dark it is where tissue stands between a place and the lamp.</source>
        <translation>Wie dunkel es ist, wo Gewebe zwischen einer Stelle und der Lampe steht.</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>How large the lamp is: 0° casts hard shadows, 45° hardly any edge.</source>
        <translation>Wie groß die Lampe ist: 0° wirft harte Schatten, 45° kaum einen Rand.</translation>
    </message>
    <message>
        <source>Dark hollows</source>
        <translation>Dunkle Vertiefungen</translation>
    </message>
    <message>
        <source>How much less light from all sides reaches hollows and what lies close together (occlusion).</source>
        <translation>Wie viel weniger Licht von allen Seiten in Vertiefungen und zwischen eng Benachbartem ankommt (Verdeckung).</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>How far away what stands around a place still darkens it.</source>
        <translation>Aus welcher Entfernung das, was um eine Stelle steht, sie noch verdunkelt.</translation>
    </message>
    <message>
        <source>The lamp is where the viewer is: drag it off, or choose another position.</source>
        <translation>Die Lampe ist beim Betrachter: Ziehen Sie sie weg, oder wählen Sie eine andere Position.</translation>
    </message>
    <message>
        <source>A lamp at the viewer casts no shadow that can be seen: drag it off, or choose another position.</source>
        <translation>Eine Lampe beim Betrachter wirft keinen sichtbaren Schatten: Ziehen Sie sie weg, oder wählen Sie eine andere Position.</translation>
    </message>
    <message>
        <source>Physical</source>
        <translation>Physikalisch</translation>
    </message>
    <message>
        <source>Physical light has its own strengths: they lie in the section below.</source>
        <translation>Physikalisches Licht hat eigene Stärken: Sie stehen im Abschnitt darunter.</translation>
    </message>
    <message>
        <source>Smoothing of normals</source>
        <translation>Glättung der Normalen</translation>
    </message>
    <message>
        <source>Softness of shadows</source>
        <translation>Weichheit der Schatten</translation>
    </message>
    <message>
        <source>Reach of the darkening</source>
        <translation>Reichweite der Abdunklung</translation>
    </message>
</context>
<context>
    <name>limn::LoadingPanel</name>
    <message>
        <source>Loading progress</source>
        <translation>Fortschritt des Ladens</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>limn::LookController</name>
    <message>
        <source>Import looks</source>
        <translation>Darstellungen importieren</translation>
    </message>
    <message>
        <source>Presets imported: %1</source>
        <translation>Importierte Presets: %1</translation>
    </message>
    <message>
        <source>Imported &quot;%1&quot;</source>
        <translation>„%1“ importiert</translation>
    </message>
    <message>
        <source>%1. Files refused: %2</source>
        <translation>%1. Abgelehnte Dateien: %2</translation>
    </message>
    <message>
        <source>Imported looks</source>
        <translation>Importierte Darstellungen</translation>
    </message>
    <message>
        <source>%1. What became of each file:</source>
        <translation>%1. Was aus jeder Datei wurde:</translation>
    </message>
    <message>
        <source>Export the look</source>
        <translation>Darstellung exportieren</translation>
    </message>
    <message>
        <source>Exported look</source>
        <translation>Exportierte Darstellung</translation>
    </message>
    <message>
        <source>written</source>
        <translation>geschrieben</translation>
    </message>
    <message>
        <source>The file was written. What it holds otherwise than shown, or not at all:</source>
        <translation>Die Datei wurde geschrieben. Was sie anders enthält als gezeigt, oder gar nicht:</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>Makes presets of your own from files of Limn or another program.</source>
        <translation>Macht aus Dateien von Limn oder einem anderen Programm eigene Presets.</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>Writes the curve and the light that are shown, of two pictures the right one&apos;s, as a file of Limn or another program.</source>
        <translation>Schreibt die gezeigte Kurve und das gezeigte Licht, von zwei Bildern die des rechten, als Datei von Limn oder einem anderen Programm.</translation>
    </message>
</context>
<context>
    <name>limn::LookReport</name>
    <message>
        <source>What changed</source>
        <translation>Was sich geändert hat</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>limn::MapSection</name>
    <message>
        <source>Not converged: the exact picture still changes with finer steps, so there is nothing to compare with.</source>
        <translation>Nicht konvergiert: Das exakte Bild ändert sich mit feineren Schritten noch, deshalb fehlt der Vergleich.</translation>
    </message>
    <message>
        <source>%1, compared at %2 × %3 pixels: 999 of 1000 colour values are within %4 levels of 255; %5 % of the pixels are off by more than one.</source>
        <translation>%1, verglichen bei %2 × %3 Pixeln: 999 von 1000 Farbwerten liegen höchstens %4 von 255 Stufen daneben; %5&#xa0;% der Pixel sind um mehr als eine falsch.</translation>
    </message>
    <message>
        <source>Where it differs</source>
        <translation>Wo es abweicht</translation>
    </message>
    <message>
        <source>Show where it is not exact</source>
        <translation>Zeigen, wo es nicht exakt ist</translation>
    </message>
    <message>
        <source>Comparing with the exact picture</source>
        <translation>Vergleich mit dem exakten Bild</translation>
    </message>
    <message>
        <source>%1, at %2 × %3 pixels: the standard error of 999 of 1000 colour values is at most %4 levels of 255; that of %5 % of the pixels is more than one.</source>
        <translation>%1, bei %2 × %3 Bildpunkten: Der Standardfehler von 999 von 1000 Farbwerten ist höchstens %4 Stufen von 255; der von %5&#xa0;% der Bildpunkte ist größer als eine.</translation>
    </message>
    <message>
        <source>%1: the error is not known, because only what two paths or more differ by tells it.</source>
        <translation>%1: Der Fehler ist nicht bekannt, denn erst worin sich zwei oder mehr Pfade unterscheiden, sagt ihn.</translation>
    </message>
    <message>
        <source>&lt;p&gt;Colours the picture by how far it lies from the exact one, in levels of 255. That one is drawn first, which takes from seconds to some minutes and says how long as it goes on. The next change of the picture takes the map away.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Färbt das Bild danach, wie weit es neben dem exakten liegt, in Stufen von 255. Dieses wird zuerst gezeichnet; das dauert Sekunden bis einige Minuten, und wie lange noch, steht währenddessen da. Die nächste Änderung des Bildes nimmt die Karte weg.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>limn::MeasureController</name>
    <message>
        <source>An ellipse is drawn in a slice; View ▸ Slices shows them.</source>
        <translation>Eine Ellipse wird in einem Schnitt gezeichnet; Ansicht ▸ Schnitte zeigt sie.</translation>
    </message>
    <message>
        <source>In an average every depth counts alike, so that there is no place to measure at.</source>
        <translation>In einem Mittelwert zählt jede Tiefe gleich viel, also gibt es keinen Ort, an dem gemessen werden könnte.</translation>
    </message>
    <message>
        <source>Click both ends</source>
        <translation>Beide Enden anklicken</translation>
    </message>
    <message>
        <source>Click end, corner and end</source>
        <translation>Ende, Scheitel und Ende anklicken</translation>
    </message>
    <message>
        <source>Click the place to mark</source>
        <translation>Die Stelle anklicken</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>In a slice, drag from corner to corner or click both</source>
        <translation>In einer Schicht von Ecke zu Ecke ziehen oder beide anklicken</translation>
    </message>
    <message>
        <source>Now the opposite corner, which ends it. Esc takes it back.</source>
        <translation>Jetzt die Ecke gegenüber, damit ist es fertig. Esc nimmt es zurück.</translation>
    </message>
    <message>
        <source>Now the corner of the angle. Esc takes it back.</source>
        <translation>Jetzt der Scheitel des Winkels. Esc nimmt es zurück.</translation>
    </message>
    <message>
        <source>Now the other end, which ends it. Esc takes it back.</source>
        <translation>Jetzt das andere Ende, damit ist es fertig. Esc nimmt es zurück.</translation>
    </message>
    <message>
        <source>A drag over tissue measures, too; one beside it rotates the picture, as does any while ends are missing. What was measured is led by its ends and goes with Delete. Esc takes back what is begun, then lays the tool aside.</source>
        <translation>Auch Ziehen über Gewebe misst; Ziehen daneben dreht das Bild, ebenso solange Enden fehlen. Gemessenes wird an seinen Enden geführt und verschwindet mit Entf. Esc nimmt Begonnenes zurück und legt dann das Werkzeug weg.</translation>
    </message>
    <message>
        <source>What was measured is led by its ends and goes with Delete; a drag over the picture rotates it. Esc takes back what is begun, then lays the tool aside.</source>
        <translation>Gemessenes wird an seinen Enden geführt und verschwindet mit Entf; Ziehen über das Bild dreht es. Esc nimmt Begonnenes zurück und legt dann das Werkzeug weg.</translation>
    </message>
</context>
<context>
    <name>limn::MeasureSection</name>
    <message>
        <source>Measures from one end to the other: drag in a slice, or click both ends in the picture (D).</source>
        <translation>Misst von einem Ende zum anderen: in einem Schnitt ziehen oder im Bild beide Enden anklicken (D).</translation>
    </message>
    <message>
        <source>Measures at a corner: drag from an end to it in a slice and click the other end, or click all three in the picture (G).</source>
        <translation>Misst an einem Scheitel: in einem Schnitt von einem Ende zu ihm ziehen und das andere Ende anklicken, oder alle drei im Bild anklicken (G).</translation>
    </message>
    <message>
        <source>Mean, deviation and area of what lies in an ellipse: drag in a slice (E).</source>
        <translation>Mittelwert, Streuung und Fläche dessen, was in einer Ellipse liegt: in einem Schnitt ziehen (E).</translation>
    </message>
    <message>
        <source>Marks a place: click in a slice or in the picture (N).</source>
        <translation>Markiert einen Ort: in einem Schnitt oder im Bild klicken (N).</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>What was measured; marked ones are shown. A click goes there, a double click renames.</source>
        <translation>Was gemessen wurde; markierte werden gezeigt. Ein Klick führt hin, ein Doppelklick benennt um.</translation>
    </message>
    <message>
        <source>Takes the chosen measurement away.</source>
        <translation>Löscht die gewählte Messung.</translation>
    </message>
    <message>
        <source>Measure: %1</source>
        <translation>Messen: %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>show: %1</source>
        <translation>zeigen: %1</translation>
    </message>
    <message>
        <source>hide: %1</source>
        <translation>ausblenden: %1</translation>
    </message>
    <message>
        <source>rename: %1</source>
        <translation>umbenennen: %1</translation>
    </message>
</context>
<context>
    <name>limn::MeasuredSection</name>
    <message>
        <source>Measured on this computer</source>
        <translation>Auf diesem Rechner gemessen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Enlarge</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Measure error and time</source>
        <translation>Fehler und Zeit messen</translation>
    </message>
    <message>
        <source>&lt;p&gt;Draws this picture from fast to nearly exact and times each, in at most 224 pixels each way: from seconds to some minutes. You can go on working; work beside it makes its times longer.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Zeichnet dieses Bild von schnell bis fast exakt und misst jeweils die Zeit, mit höchstens 224 Pixeln je Seite; das dauert Sekunden bis einige Minuten. Sie können weiterarbeiten; die gemessenen Zeiten werden dadurch länger.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Save what was measured</source>
        <translation>Messung speichern</translation>
    </message>
    <message>
        <source>Writes the chart as a picture (PNG), the numbers as a table (CSV), or both as a page (HTML).</source>
        <translation>Schreibt das Diagramm als Bild (PNG), die Zahlen als Tabelle (CSV) oder beides als Seite (HTML).</translation>
    </message>
    <message>
        <source>Chart in a window of its own</source>
        <translation>Diagramm in eigenem Fenster</translation>
    </message>
    <message>
        <source>Shows the chart in a window of its own, where it is larger.</source>
        <translation>Zeigt das Diagramm in einem eigenen Fenster, wo es größer ist.</translation>
    </message>
    <message>
        <source>Error shown</source>
        <translation>Gezeigter Fehler</translation>
    </message>
    <message>
        <source>The 99.9th percentile is the error that 999 of 1000 colour values stay within; the mean is taken over all of them.</source>
        <translation>Das 99,9. Perzentil ist der Fehler, den 999 von 1000 Farbwerten nicht überschreiten; der Mittelwert gilt für alle.</translation>
    </message>
    <message>
        <source>99.9th percentile</source>
        <translation>99,9. Perzentil</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Nothing is measured yet. Measure tells the error and the time of this picture, from fast to exact.</source>
        <translation>Noch ist nichts gemessen. „Messen“ nennt Fehler und Zeit dieses Bildes, von schnell bis exakt.</translation>
    </message>
    <message>
        <source>Times are scaled from there to the %1 × %2 pixels on screen.</source>
        <translation>Zeiten sind von dort auf die %1 × %2 Pixel am Bildschirm umgerechnet.</translation>
    </message>
    <message>
        <source>Measured in another view. %1</source>
        <translation>In einer anderen Ansicht gemessen. %1</translation>
    </message>
    <message>
        <source>Measured for an earlier picture; measure again to judge this one.</source>
        <translation>Für ein früheres Bild gemessen; messen Sie neu, um dieses zu beurteilen.</translation>
    </message>
    <message>
        <source>Drawn by %1</source>
        <translation>Gezeichnet von %1</translation>
    </message>
    <message>
        <source>At %1 × %2 pixels.</source>
        <translation>Bei %1 × %2 Pixeln.</translation>
    </message>
</context>
<context>
    <name>limn::Message</name>
    <message>
        <source>Making the phantom</source>
        <translation>Phantom wird erzeugt</translation>
    </message>
    <message>
        <source>Finding what is visible</source>
        <translation>Sichtbares wird gesucht</translation>
    </message>
    <message>
        <source>Looking for the steps that are needed</source>
        <translation>Nötige Schrittweiten werden gesucht</translation>
    </message>
    <message>
        <source>Drawing the exact picture</source>
        <translation>Exaktes Bild wird gezeichnet</translation>
    </message>
    <message>
        <source>Straightening slices</source>
        <translation>Schichten werden begradigt</translation>
    </message>
    <message>
        <source>Reading segments</source>
        <translation>Segmente werden gelesen</translation>
    </message>
    <message>
        <source>Reading slices</source>
        <translation>Schichten werden gelesen</translation>
    </message>
    <message>
        <source>Reading headers</source>
        <translation>Header werden gelesen</translation>
    </message>
    <message>
        <source>Reading voxels</source>
        <translation>Voxel werden gelesen</translation>
    </message>
    <message>
        <source>Placing labels</source>
        <translation>Labels werden eingepasst</translation>
    </message>
    <message>
        <source>Counting values</source>
        <translation>Werte werden gezählt</translation>
    </message>
    <message>
        <source>every voxel has the same value, so there are no boundaries</source>
        <translation>jedes Voxel hat denselben Wert, deshalb gibt es keine Grenzflächen</translation>
    </message>
    <message>
        <source>the chosen model lights the volume</source>
        <translation>das gewählte Modell beleuchtet das Volumen</translation>
    </message>
    <message>
        <source>the chosen model shows plain colours without light</source>
        <translation>das gewählte Modell zeigt reine Farben ohne Licht</translation>
    </message>
    <message>
        <source>light or boundary settings need to know where boundaries lie</source>
        <translation>Licht- oder Grenzflächeneinstellungen müssen wissen, wo Grenzflächen liegen</translation>
    </message>
    <message>
        <source>nothing in this picture depends on boundaries</source>
        <translation>nichts in diesem Bild hängt von Grenzflächen ab</translation>
    </message>
    <message>
        <source>surfaces are brighter where they face the light</source>
        <translation>Flächen sind heller, wo sie dem Licht zugewandt sind</translation>
    </message>
    <message>
        <source>the diffuse light is set to 0</source>
        <translation>das diffuse Licht ist auf 0 gesetzt</translation>
    </message>
    <message>
        <source>surfaces shine where they mirror the light</source>
        <translation>Flächen glänzen, wo sie das Licht spiegeln</translation>
    </message>
    <message>
        <source>the strength of the highlights is set to 0</source>
        <translation>die Stärke der Glanzlichter ist auf 0 gesetzt</translation>
    </message>
    <message>
        <source>their shape is Phong&apos;s</source>
        <translation>ihre Form ist die von Phong</translation>
    </message>
    <message>
        <source>their shape is Blinn&apos;s, or there are none</source>
        <translation>ihre Form ist die von Blinn, oder es gibt keine</translation>
    </message>
    <message>
        <source>the inner sides of surfaces are lit as well</source>
        <translation>auch die Innenseiten der Flächen sind beleuchtet</translation>
    </message>
    <message>
        <source>surfaces are lit on their outer side only</source>
        <translation>Flächen sind nur an der Außenseite beleuchtet</translation>
    </message>
    <message>
        <source>no light falls on surfaces</source>
        <translation>auf Flächen fällt kein Licht</translation>
    </message>
    <message>
        <source>the light comes from a direction of its own</source>
        <translation>das Licht kommt aus einer eigenen Richtung</translation>
    </message>
    <message>
        <source>the light comes from the viewer</source>
        <translation>das Licht kommt vom Betrachter</translation>
    </message>
    <message>
        <source>they take the light&apos;s colour</source>
        <translation>sie nehmen die Farbe des Lichts an</translation>
    </message>
    <message>
        <source>they take the tissue&apos;s colour</source>
        <translation>sie nehmen die Farbe des Gewebes an</translation>
    </message>
    <message>
        <source>strong boundaries shine more sharply than weak ones</source>
        <translation>starke Grenzflächen glänzen schärfer als schwache</translation>
    </message>
    <message>
        <source>there are no highlights</source>
        <translation>es gibt keine Glanzlichter</translation>
    </message>
    <message>
        <source>highlights are equally sharp everywhere</source>
        <translation>Glanzlichter sind überall gleich scharf</translation>
    </message>
    <message>
        <source>strong boundaries are made more opaque than weak ones</source>
        <translation>starke Grenzflächen werden deckender gemacht als schwache</translation>
    </message>
    <message>
        <source>boundaries are as opaque as the curve says</source>
        <translation>Grenzflächen sind so deckend, wie die Kurve es vorgibt</translation>
    </message>
    <message>
        <source>every opacity is multiplied by the same factor</source>
        <translation>jede Deckkraft wird mit demselben Faktor multipliziert</translation>
    </message>
    <message>
        <source>opacities are not changed by a constant factor</source>
        <translation>die Deckkraft wird durch keinen festen Faktor geändert</translation>
    </message>
    <message>
        <source>the strength of boundaries counts as measured (linear)</source>
        <translation>die Stärke der Grenzflächen zählt wie gemessen (linear)</translation>
    </message>
    <message>
        <source>nothing depends on the strength of boundaries</source>
        <translation>nichts hängt von der Stärke der Grenzflächen ab</translation>
    </message>
    <message>
        <source>weak and strong boundaries are weighed by a power (gamma)</source>
        <translation>schwache und starke Grenzflächen werden nach einer Potenz gewichtet (Gamma)</translation>
    </message>
    <message>
        <source>weak and strong boundaries are weighed by a logarithm</source>
        <translation>schwache und starke Grenzflächen werden logarithmisch gewichtet</translation>
    </message>
    <message>
        <source>a curve says how opaque boundaries are by their strength</source>
        <translation>eine Kurve bestimmt, wie deckend Grenzflächen nach ihrer Stärke sind</translation>
    </message>
    <message>
        <source>no curve of opacity over the strength of boundaries is set</source>
        <translation>es ist keine Kurve der Deckkraft über der Stärke der Grenzflächen gesetzt</translation>
    </message>
    <message>
        <source>broad highlights carry no more light than sharp ones</source>
        <translation>breite Glanzlichter tragen nicht mehr Licht als scharfe</translation>
    </message>
    <message>
        <source>highlights are equally sharp, or their light is not evened out</source>
        <translation>Glanzlichter sind gleich scharf, oder ihr Licht wird nicht ausgeglichen</translation>
    </message>
    <message>
        <source>the robust model is not chosen</source>
        <translation>das Modell „Robust“ ist nicht gewählt</translation>
    </message>
    <message>
        <source>highlights are faded out where boundaries are insignificant</source>
        <translation>Glanzlichter werden ausgeblendet, wo Grenzflächen unbedeutend sind</translation>
    </message>
    <message>
        <source>fading out insignificant highlights is off, or there are none</source>
        <translation>das Ausblenden unbedeutender Glanzlichter ist aus, oder es gibt keine</translation>
    </message>
    <message>
        <source>light could add up to more than full brightness and would be cut off</source>
        <translation>Licht könnte sich zu mehr als voller Helligkeit addieren und würde abgeschnitten</translation>
    </message>
    <message>
        <source>the light never adds up to that much, or the limit is off</source>
        <translation>so viel Licht kommt nie zusammen, oder die Grenze ist aus</translation>
    </message>
    <message>
        <source>fog is off</source>
        <translation>Nebel ist aus</translation>
    </message>
    <message>
        <source>the density of the fog is 0</source>
        <translation>die Dichte des Nebels ist 0</translation>
    </message>
    <message>
        <source>the fog begins behind the volume</source>
        <translation>der Nebel beginnt hinter dem Volumen</translation>
    </message>
    <message>
        <source>another fog is chosen</source>
        <translation>ein anderer Nebel ist gewählt</translation>
    </message>
    <message>
        <source>linear fog is on</source>
        <translation>linearer Nebel ist an</translation>
    </message>
    <message>
        <source>exponential fog is on</source>
        <translation>exponentieller Nebel ist an</translation>
    </message>
    <message>
        <source>squared exponential fog is on</source>
        <translation>quadratisch exponentieller Nebel ist an</translation>
    </message>
    <message>
        <source>another kind of picture is chosen</source>
        <translation>eine andere Art von Bild ist gewählt</translation>
    </message>
    <message>
        <source>each ray shows its largest value</source>
        <translation>jeder Strahl zeigt seinen größten Wert</translation>
    </message>
    <message>
        <source>each ray shows its smallest value</source>
        <translation>jeder Strahl zeigt seinen kleinsten Wert</translation>
    </message>
    <message>
        <source>each ray shows its mean value</source>
        <translation>jeder Strahl zeigt seinen mittleren Wert</translation>
    </message>
    <message>
        <source>each ray shows how much it absorbs</source>
        <translation>jeder Strahl zeigt, wie viel er absorbiert</translation>
    </message>
    <message>
        <source>the picture shows the first surface of the chosen value</source>
        <translation>das Bild zeigt die erste Oberfläche des gewählten Werts</translation>
    </message>
    <message>
        <source>the surface of the chosen value stands behind what lies before it</source>
        <translation>die Oberfläche des gewählten Werts steht hinter dem, was vor ihr liegt</translation>
    </message>
    <message>
        <source>it is set to &quot;always&quot;</source>
        <translation>auf „immer“ gesetzt</translation>
    </message>
    <message>
        <source>the curve changes faster than one step can follow</source>
        <translation>die Kurve ändert sich schneller, als ein Schritt folgen kann</translation>
    </message>
    <message>
        <source>it is set to &quot;never&quot;</source>
        <translation>auf „nie“ gesetzt</translation>
    </message>
    <message>
        <source>the steps are fine enough for this curve</source>
        <translation>die Schritte sind für diese Kurve fein genug</translation>
    </message>
    <message>
        <source>it is switched on: neighbouring pixels sample at other depths</source>
        <translation>eingeschaltet: benachbarte Pixel tasten in anderen Tiefen ab</translation>
    </message>
    <message>
        <source>it is switched off</source>
        <translation>ausgeschaltet</translation>
    </message>
    <message>
        <source>what lies behind opaque tissue cannot be seen and is not drawn</source>
        <translation>was hinter deckendem Gewebe liegt, ist nicht zu sehen und wird nicht gezeichnet</translation>
    </message>
    <message>
        <source>nothing in this picture is opaque enough to hide what lies behind</source>
        <translation>nichts in diesem Bild ist deckend genug, um zu verbergen, was dahinter liegt</translation>
    </message>
    <message>
        <source>rays are set to run to their end</source>
        <translation>Strahlen sollen bis zu ihrem Ende laufen</translation>
    </message>
    <message>
        <source>transparent parts of the volume are stepped over</source>
        <translation>durchsichtige Teile des Volumens werden übersprungen</translation>
    </message>
    <message>
        <source>hardly any part of the volume is transparent</source>
        <translation>kaum ein Teil des Volumens ist durchsichtig</translation>
    </message>
    <message>
        <source>the longest ray has too many samples for nested loops</source>
        <translation>der längste Strahl hat zu viele Abtastpunkte für geschachtelte Schleifen</translation>
    </message>
    <message>
        <source>every ray is short enough</source>
        <translation>jeder Strahl ist kurz genug</translation>
    </message>
    <message>
        <source>control points lie very close together</source>
        <translation>Punkte der Kurve liegen sehr dicht beieinander</translation>
    </message>
    <message>
        <source>control points lie far enough apart</source>
        <translation>Punkte der Kurve liegen weit genug auseinander</translation>
    </message>
    <message>
        <source>nothing of the volume can be seen</source>
        <translation>vom Volumen ist nichts zu sehen</translation>
    </message>
    <message>
        <source>error-controlled steps follow the curve themselves</source>
        <translation>fehlergesteuerte Schritte folgen der Kurve selbst</translation>
    </message>
    <message>
        <source>error-controlled steps leave no sample to shift</source>
        <translation>fehlergesteuerte Schritte lassen keinen Abtastpunkt zum Verschieben</translation>
    </message>
    <message>
        <source>exact steps (pre-integration) leave no sample to shift</source>
        <translation>exakte Schritte (Vorintegration) lassen keinen Abtastpunkt zum Verschieben</translation>
    </message>
    <message>
        <source>the steps are so small that rays take too many of them</source>
        <translation>die Schritte sind so klein, dass Strahlen zu viele davon machen</translation>
    </message>
    <message>
        <source>nothing that can be seen depends on it</source>
        <translation>nichts Sichtbares hängt davon ab</translation>
    </message>
    <message>
        <source>this kind of picture has no use for it</source>
        <translation>diese Art von Bild kann damit nichts anfangen</translation>
    </message>
    <message>
        <source>the cuts of the crop box are lit as surfaces</source>
        <translation>die Schnittflächen der Zuschnittbox sind als Oberflächen beleuchtet</translation>
    </message>
    <message>
        <source>the crop box keeps the whole volume</source>
        <translation>die Zuschnittbox behält das ganze Volumen</translation>
    </message>
    <message>
        <source>no light falls on the cuts</source>
        <translation>auf die Schnittflächen fällt kein Licht</translation>
    </message>
    <message>
        <source>what is not body is hidden</source>
        <translation>was nicht zum Körper gehört, ist ausgeblendet</translation>
    </message>
    <message>
        <source>some labels are hidden or faded</source>
        <translation>einige Labels sind ausgeblendet oder abgeschwächt</translation>
    </message>
    <message>
        <source>every label is shown</source>
        <translation>jedes Label wird gezeigt</translation>
    </message>
    <message>
        <source>all of the volume is kept</source>
        <translation>das ganze Volumen wird behalten</translation>
    </message>
    <message>
        <source>samples are spent where the picture needs them to keep to the tolerance</source>
        <translation>abgetastet wird dort, wo das Bild es braucht, um die Toleranz einzuhalten</translation>
    </message>
    <message>
        <source>no tolerance is set, so every step is equally long</source>
        <translation>es ist keine Toleranz gesetzt, deshalb ist jeder Schritt gleich lang</translation>
    </message>
    <message>
        <source>only the measure of overflow draws it</source>
        <translation>nur das Messen der Überstrahlung zeichnet es</translation>
    </message>
    <message>
        <source>only tests draw it</source>
        <translation>nur Tests zeichnen es</translation>
    </message>
    <message>
        <source>There is no volume to draw; open one first.</source>
        <translation>Es gibt kein Volumen zu zeichnen; öffnen Sie zuerst eines.</translation>
    </message>
    <message>
        <source>Boundaries (gradient)</source>
        <translation>Grenzflächen (Gradient)</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Highlights</source>
        <translation>Glanzlichter</translation>
    </message>
    <message>
        <source>Highlight sharpness by boundary (SP)</source>
        <translation>Glanzlichtschärfe nach Grenzfläche (SP)</translation>
    </message>
    <message>
        <source>Boundary emphasis (O)</source>
        <translation>Grenzflächen­betonung (O)</translation>
    </message>
    <message>
        <source>Curve over boundary strength</source>
        <translation>Kurve über der Grenzflächenstärke</translation>
    </message>
    <message>
        <source>Robust highlights</source>
        <translation>Robuste Glanzlichter</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>Crop box</source>
        <translation>Zuschnittbox</translation>
    </message>
    <message>
        <source>Rays end early</source>
        <translation>Strahlen enden vorzeitig</translation>
    </message>
    <message>
        <source>Exact within each step (pre-integration)</source>
        <translation>Exakt in jedem Schritt (Vorintegration)</translation>
    </message>
    <message>
        <source>Skip empty space</source>
        <translation>Leeren Raum überspringen</translation>
    </message>
    <message>
        <source>Opacity by boundary strength</source>
        <translation>Deckkraft nach Grenzflächenstärke</translation>
    </message>
    <message>
        <source>Surface of one value</source>
        <translation>Oberfläche eines Werts</translation>
    </message>
    <message>
        <source>Shifted samples (jitter)</source>
        <translation>Verschobene Abtastpunkte (Jitter)</translation>
    </message>
    <message>
        <source>Soft limit of brightness (knee)</source>
        <translation>Weiche Grenze der Helligkeit (Knie)</translation>
    </message>
    <message>
        <source>Light on both sides</source>
        <translation>Licht auf beiden Seiten</translation>
    </message>
    <message>
        <source>Kept region</source>
        <translation>Behaltener Bereich</translation>
    </message>
    <message>
        <source>the crop box cuts the volume, and the cuts are lit as surfaces</source>
        <translation>die Zuschnittbox schneidet das Volumen, und die Schnittflächen sind als Oberflächen beleuchtet</translation>
    </message>
    <message>
        <source>the crop box cuts the volume</source>
        <translation>die Zuschnittbox schneidet das Volumen</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>saves %1</source>
        <translation>spart %1</translation>
    </message>
    <message>
        <source>slices are blended one after the other and none knows which pixels are done</source>
        <translation>Schnitte werden nacheinander überblendet, und keiner weiß, welche Pixel fertig sind</translation>
    </message>
    <message>
        <source>a slice is one sample: there is nothing to step over</source>
        <translation>ein Schnitt ist ein Abtastpunkt: es gibt nichts zu überspringen</translation>
    </message>
    <message>
        <source>slices do not march along rays, so no ray is too long</source>
        <translation>Schnitte folgen keinen Strahlen, deshalb ist kein Strahl zu lang</translation>
    </message>
    <message>
        <source>In a trial on this computer a small picture took %1 ms with OpenGL and %2 ms with the processor.</source>
        <translation>In einem Versuch auf diesem Rechner dauerte ein kleines Bild %1&#xa0;ms mit OpenGL und %2&#xa0;ms mit dem Prozessor.</translation>
    </message>
    <message>
        <source>The graphics driver has no card and draws on the processor itself, where the CPU engine is likely to be faster.</source>
        <translation>Der Grafiktreiber hat keine Karte und zeichnet selbst auf dem Prozessor, wo die CPU-Engine wahrscheinlich schneller ist.</translation>
    </message>
    <message>
        <source>A graphics card is likely to be faster than the processor.</source>
        <translation>Eine Grafikkarte ist wahrscheinlich schneller als der Prozessor.</translation>
    </message>
    <message>
        <source>The picture is %1.</source>
        <translation>Das Bild ist %1.</translation>
    </message>
    <message>
        <source>%1 The CPU engine drew the picture instead.</source>
        <translation>%1 Stattdessen hat die CPU-Engine das Bild gezeichnet.</translation>
    </message>
    <message>
        <source>Looking for the body</source>
        <translation>Körper wird gesucht</translation>
    </message>
    <message>
        <source>No body was found in the volume (%1), so everything is kept.</source>
        <translation>Im Volumen wurde kein Körper gefunden (%1), deshalb wird alles behalten.</translation>
    </message>
    <message>
        <source>Cannot save the preset: its name is too long for a file; choose a shorter one.</source>
        <translation>Das Preset kann nicht gespeichert werden: Sein Name ist für eine Datei zu lang; wählen Sie einen kürzeren.</translation>
    </message>
    <message>
        <source>Cannot delete the preset &quot;%1&quot;: %2.</source>
        <translation>Das Preset „%1“ kann nicht gelöscht werden: %2.</translation>
    </message>
    <message>
        <source>There is no preset &quot;%1&quot;; there are: %2.</source>
        <translation>Es gibt kein Preset „%1“; vorhanden sind: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a phantom; write phantom:SPACING, such as phantom:1.5.</source>
        <translation>„%1“ ist kein Phantom; schreiben Sie phantom:ABSTAND, etwa phantom:1.5.</translation>
    </message>
    <message>
        <source>No example head is installed (package invesalius-examples), so the built-in phantom is shown.</source>
        <translation>Kein Beispielkopf ist installiert (Paket invesalius-examples), deshalb wird das eingebaute Phantom gezeigt.</translation>
    </message>
    <message>
        <source>This is no DICOM series; its number %1 was ignored.</source>
        <translation>Dies ist keine DICOM-Serie; ihre Nummer %1 wurde nicht beachtet.</translation>
    </message>
    <message>
        <source>The slices lie %1 mm apart, %2 times as far as the pixels within them: surfaces show a band for each slice.</source>
        <translation>Die Schichten liegen %1&#xa0;mm auseinander, %2-mal so weit wie die Pixel in ihnen: Oberflächen zeigen je Schicht ein Band.</translation>
    </message>
    <message>
        <source>The scene&apos;s volume %1 is not where the scene expects it (%2); say where it is (--volume PATH).</source>
        <translation>Das Volumen %1 der Szene ist nicht dort, wo die Szene es erwartet (%2); geben Sie an, wo es ist (--volume PFAD).</translation>
    </message>
    <message>
        <source>Cannot make the folder %1: %2; make room there or allow Limn to write there.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden: %2; schaffen Sie dort Platz, oder erlauben Sie Limn, dort zu schreiben.</translation>
    </message>
    <message>
        <source>The chart cannot be written as PNG; is there memory left?</source>
        <translation>Das Diagramm lässt sich nicht als PNG schreiben; ist noch Speicher frei?</translation>
    </message>
    <message>
        <source>drawing the picture</source>
        <translation>beim Zeichnen des Bildes</translation>
    </message>
    <message>
        <source>Measuring %1, %2</source>
        <translation>Messung: %1, %2</translation>
    </message>
    <message>
        <source>%1 level</source>
        <translation>%1 Stufe</translation>
    </message>
    <message>
        <source>%1 levels</source>
        <translation>%1 Stufen</translation>
    </message>
    <message>
        <source>The tolerance of %1 cannot be kept: a peak or valley of the transfer function is so narrow that even the finest step may miss it; make it wider.</source>
        <translation>Die Toleranz von %1 lässt sich nicht einhalten: Eine Spitze oder ein Tal der Transferfunktion ist so schmal, dass selbst der feinste Schritt sie verfehlen kann; machen Sie sie breiter.</translation>
    </message>
    <message>
        <source>The tolerance of %1 cannot be kept: the finest step comes within about %2; make the steps of the transfer function less steep, or allow that many levels.</source>
        <translation>Die Toleranz von %1 lässt sich nicht einhalten: Der feinste Schritt kommt bis auf etwa %2 heran; machen Sie die Flanken der Transferfunktion weniger steil, oder lassen Sie so viele Stufen zu.</translation>
    </message>
    <message>
        <source>99.9 % of the pixels lie within %1 of 255 levels of the exact picture (95 % sure: of %2 drawn at random and integrated exactly none lies farther off).</source>
        <translation>99,9&#xa0;% der Bildpunkte weichen höchstens um %1 von 255 Stufen vom exakten Bild ab (zu 95&#xa0;% sicher: Von %2 zufällig gewählten und exakt integrierten liegt keiner weiter daneben).</translation>
    </message>
    <message>
        <source>exact but for rounding, found cell by cell</source>
        <translation>bis auf Rundung exakt, Zelle für Zelle bestimmt</translation>
    </message>
    <message>
        <source>error-controlled steps of fineness %1</source>
        <translation>fehlergesteuerten Schritten der Feinheit %1</translation>
    </message>
    <message>
        <source>equal steps of %1 voxels</source>
        <translation>gleichen Schritten von %1 Voxeln</translation>
    </message>
    <message>
        <source>estimated within %1, with %2</source>
        <translation>nach Schätzung auf %1 genau, mit %2</translation>
    </message>
    <message>
        <source>The step is so small that long rays would need more than %1 samples; they are drawn with that number.</source>
        <translation>Die Schritte sind so klein, dass lange Strahlen mehr als %1 Abtastpunkte bräuchten; sie werden mit dieser Zahl gezeichnet.</translation>
    </message>
    <message>
        <source>The graphics driver offers OpenGL %1.%2, but drawing needs OpenGL 3.0; update the driver or install Mesa&apos;s software driver (libgl1-mesa-dri).</source>
        <translation>Der Grafiktreiber bietet OpenGL %1.%2, zum Zeichnen braucht es OpenGL 3.0; aktualisieren Sie den Treiber, oder installieren Sie den Softwaretreiber von Mesa (libgl1-mesa-dri).</translation>
    </message>
    <message>
        <source>The graphics driver was reset while %1; try again, and if it happens often, draw with a larger step, in a smaller picture or with --engine cpu.</source>
        <translation>Der Grafiktreiber wurde %1 zurückgesetzt; versuchen Sie es noch einmal, und wenn es oft geschieht, zeichnen Sie mit größeren Schritten, in einem kleineren Bild oder mit --engine cpu.</translation>
    </message>
    <message>
        <source>The graphics driver ran out of memory while %1; close other programs that draw, choose a smaller picture or use --engine cpu.</source>
        <translation>Dem Grafiktreiber ging %1 der Speicher aus; schließen Sie andere Programme, die zeichnen, wählen Sie ein kleineres Bild, oder verwenden Sie --engine cpu.</translation>
    </message>
    <message>
        <source>The graphics driver refused a command while %1; update the driver or use --engine cpu, and please report it with `limn info --system`.</source>
        <translation>Der Grafiktreiber hat %1 einen Befehl verweigert; aktualisieren Sie den Treiber, oder verwenden Sie --engine cpu, und melden Sie es bitte mit „limn info --system“.</translation>
    </message>
    <message>
        <source>The graphics driver cannot draw a picture of %1×%2 pixels in floats; try a smaller one or --engine cpu.</source>
        <translation>Der Grafiktreiber kann kein Bild von %1×%2 Pixeln in Gleitkommazahlen zeichnen; versuchen Sie ein kleineres oder --engine cpu.</translation>
    </message>
    <message>
        <source>No OpenGL without a display: %1. Install the packages libegl1 and libgl1-mesa-dri (or the graphics card&apos;s driver), or use --engine cpu.</source>
        <translation>Kein OpenGL ohne Bildschirm: %1. Installieren Sie die Pakete libegl1 und libgl1-mesa-dri (oder den Treiber der Grafikkarte), oder verwenden Sie --engine cpu.</translation>
    </message>
    <message>
        <source>no EGL display could be opened</source>
        <translation>es ließ sich keine EGL-Anzeige öffnen</translation>
    </message>
    <message>
        <source>the driver cannot draw without a surface</source>
        <translation>der Treiber kann nicht ohne Fläche zeichnen</translation>
    </message>
    <message>
        <source>the driver offers OpenGL ES only</source>
        <translation>der Treiber bietet nur OpenGL ES</translation>
    </message>
    <message>
        <source>the driver has no configuration for OpenGL</source>
        <translation>der Treiber hat keine Konfiguration für OpenGL</translation>
    </message>
    <message>
        <source>the driver could not make an OpenGL context</source>
        <translation>der Treiber konnte keinen OpenGL-Kontext anlegen</translation>
    </message>
    <message>
        <source>the OpenGL context could not be made current</source>
        <translation>der OpenGL-Kontext ließ sich nicht aktivieren</translation>
    </message>
    <message>
        <source>The graphics driver cannot draw a picture of %1 × %2 pixels in 32-bit floats; make the window smaller or install a driver with OpenGL 3.0 or newer.</source>
        <translation>Der Grafiktreiber kann kein Bild von %1 × %2 Pixeln in 32-Bit-Gleitkommazahlen zeichnen; machen Sie das Fenster kleiner, oder installieren Sie einen Treiber mit OpenGL 3.0 oder neuer.</translation>
    </message>
    <message>
        <source>The graphics driver refused a shader; update the driver or use --engine cpu, and please report it with `limn info --system`.</source>
        <translation>Der Grafiktreiber hat einen Shader verweigert; aktualisieren Sie den Treiber, oder verwenden Sie --engine cpu, und melden Sie es bitte mit „limn info --system“.</translation>
    </message>
    <message>
        <source>The graphics driver could not link a shader program; update the driver or use --engine cpu, and please report it with `limn info --system`.</source>
        <translation>Der Grafiktreiber konnte ein Shaderprogramm nicht binden; aktualisieren Sie den Treiber, oder verwenden Sie --engine cpu, und melden Sie es bitte mit „limn info --system“.</translation>
    </message>
    <message>
        <source>The graphics driver has no room for the kept region; draw all of the volume, or with --engine cpu.</source>
        <translation>Der Grafiktreiber hat keinen Platz für den behaltenen Bereich; zeichnen Sie das ganze Volumen, oder verwenden Sie --engine cpu.</translation>
    </message>
    <message>
        <source>The graphics driver refused even a tiny 3D texture; update the driver or draw with --engine cpu.</source>
        <translation>Der Grafiktreiber hat selbst eine winzige 3D-Textur verweigert; aktualisieren Sie den Treiber, oder zeichnen Sie mit --engine cpu.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>The volume of %1 voxels is too large for the graphics memory that it may take</source>
        <translation>Das Volumen von %1 Voxeln ist zu groß für den Grafikspeicher, den es belegen darf</translation>
    </message>
    <message>
        <source>The volume of %1 voxels is too large for the graphics driver</source>
        <translation>Das Volumen von %1 Voxeln ist zu groß für den Grafiktreiber</translation>
    </message>
    <message>
        <source>%1 and is shown with %2.</source>
        <translation>%1 und wird mit %2 gezeigt.</translation>
    </message>
    <message>
        <source>The graphics driver has no room for %1, %2 MB; draw without them.</source>
        <translation>Der Grafiktreiber hat keinen Platz für %1, %2&#xa0;MB; zeichnen Sie ohne sie.</translation>
    </message>
    <message>
        <source>choose another folder or make room</source>
        <translation>wählen Sie einen anderen Ordner, oder schaffen Sie Platz</translation>
    </message>
    <message>
        <source>make room there or allow Limn to write there</source>
        <translation>schaffen Sie dort Platz, oder erlauben Sie Limn, dort zu schreiben</translation>
    </message>
    <message>
        <source>Cannot write %1: %2; %3, the old file is untouched.</source>
        <translation>%1 kann nicht geschrieben werden: %2; %3; die alte Datei ist unverändert.</translation>
    </message>
    <message>
        <source>Cannot write %1: %2; %3.</source>
        <translation>%1 kann nicht geschrieben werden: %2; %3.</translation>
    </message>
    <message>
        <source>%1 (%2, %3 × %4, %5 image)</source>
        <translation>%1 (%2, %3 × %4, %5 Bild)</translation>
    </message>
    <message>
        <source>%1 (%2, %3 × %4, %5 images)</source>
        <translation>%1 (%2, %3 × %4, %5 Bilder)</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 has no series %2; it holds %3.</source>
        <translation>%1 hat keine Serie %2; vorhanden sind %3.</translation>
    </message>
    <message>
        <source>%1 series were found and the largest is shown, %2; the others are %3. Choose one by its number.</source>
        <translation>%1 Serien wurden gefunden, und die größte wird gezeigt, %2; die anderen sind %3. Wählen Sie eine nach ihrer Nummer.</translation>
    </message>
    <message>
        <source>%1 DICOM file is damaged or cut off and was left out (%2): slices may be missing; copy the series again.</source>
        <translation>%1 DICOM-Datei ist beschädigt oder abgeschnitten und wurde weggelassen (%2): Es können Schichten fehlen; kopieren Sie die Serie neu.</translation>
    </message>
    <message>
        <source>%1 DICOM files are damaged or cut off and were left out (%2): slices may be missing; copy the series again.</source>
        <translation>%1 DICOM-Dateien sind beschädigt oder abgeschnitten und wurden weggelassen (%2): Es können Schichten fehlen; kopieren Sie die Serie neu.</translation>
    </message>
    <message>
        <source>This is a single image; open its folder to see the whole series.</source>
        <translation>Dies ist ein einzelnes Bild; öffnen Sie seinen Ordner, um die ganze Serie zu sehen.</translation>
    </message>
    <message>
        <source>The folder holds several series; choose one by its number.</source>
        <translation>Der Ordner enthält mehrere Serien; wählen Sie eine anhand ihrer Nummer.</translation>
    </message>
    <message>
        <source>DICOM objects without images only (reports, plans or indices)</source>
        <translation>nur DICOM-Objekte ohne Bilder (Befunde, Pläne oder Verzeichnisse)</translation>
    </message>
    <message>
        <source>only DICOM files that are damaged or cut off (%1)</source>
        <translation>nur DICOM-Dateien, die beschädigt oder abgeschnitten sind (%1)</translation>
    </message>
    <message>
        <source>The folder %1 holds %2; choose the folder of an image series.</source>
        <translation>Der Ordner %1 enthält %2; wählen Sie den Ordner einer Bildserie.</translation>
    </message>
    <message>
        <source>%1 makes a volume of %2 × %3 × %4 voxels, more than can be shown; choose a smaller series.</source>
        <translation>%1 ergibt ein Volumen von %2 × %3 × %4 Voxeln, mehr, als gezeigt werden kann; wählen Sie eine kleinere Serie.</translation>
    </message>
    <message>
        <source>it holds no segments</source>
        <translation>sie enthält keine Segmente</translation>
    </message>
    <message>
        <source>its segments are compressed</source>
        <translation>ihre Segmente sind komprimiert</translation>
    </message>
    <message>
        <source>export the segmentation uncompressed</source>
        <translation>exportieren Sie die Segmentierung unkomprimiert</translation>
    </message>
    <message>
        <source>its header contradicts itself about its pixels</source>
        <translation>ihr Header widerspricht sich bei den Pixeln</translation>
    </message>
    <message>
        <source>it is too short for the frames that it announces</source>
        <translation>sie ist zu kurz für die Bilder, die sie ankündigt</translation>
    </message>
    <message>
        <source>it does not say where its frames lie and which segment each shows</source>
        <translation>sie gibt nicht an, wo ihre Bilder liegen und welches Segment jedes zeigt</translation>
    </message>
    <message>
        <source>export it again</source>
        <translation>exportieren Sie sie neu</translation>
    </message>
    <message>
        <source>it does not say how its frames lie in the patient</source>
        <translation>sie gibt nicht an, wie ihre Bilder im Patienten liegen</translation>
    </message>
    <message>
        <source>its planes lie too far apart for one volume</source>
        <translation>ihre Ebenen liegen für ein Volumen zu weit auseinander</translation>
    </message>
    <message>
        <source>its planes make no even stack</source>
        <translation>ihre Ebenen ergeben keinen gleichmäßigen Stapel</translation>
    </message>
    <message>
        <source>export the segmentation as NRRD or NIfTI</source>
        <translation>exportieren Sie die Segmentierung als NRRD oder NIfTI</translation>
    </message>
    <message>
        <source>it is cut off within its segments</source>
        <translation>sie ist mitten in ihren Segmenten abgeschnitten</translation>
    </message>
    <message>
        <source> (%1 : 1)</source>
        <translation> (%1 : 1)</translation>
    </message>
    <message>
        <source>The images were compressed with loss%1: fine detail differs from what the scanner measured.</source>
        <translation>Die Bilder wurden verlustbehaftet komprimiert%1: Feine Einzelheiten weichen von dem ab, was das Gerät gemessen hat.</translation>
    </message>
    <message>
        <source>The file holds more pixels than its header announces; the rest is not shown.</source>
        <translation>Die Datei enthält mehr Pixel, als ihr Header ankündigt; der Rest wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>The images are meant to be shown inverted (MONOCHROME1); their values are kept as they are.</source>
        <translation>Die Bilder sollen invertiert gezeigt werden (MONOCHROME1); ihre Werte bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>The images are coloured; their luminance is shown.</source>
        <translation>Die Bilder sind farbig; ihre Helligkeit wird gezeigt.</translation>
    </message>
    <message>
        <source>The DICOM file %1 gives a rescale slope of 0 or none that is a number, which leaves no values; its header is damaged.</source>
        <translation>Die DICOM-Datei %1 nennt eine Rescale-Steigung von 0 oder keine Zahl, was keine Werte übrig lässt; ihr Header ist beschädigt.</translation>
    </message>
    <message>
        <source>Some pixels have bits set beyond those that hold the value; these bits were ignored.</source>
        <translation>Bei einigen Pixeln sind Bits außerhalb derer gesetzt, die den Wert enthalten; diese Bits wurden nicht beachtet.</translation>
    </message>
    <message>
        <source>The deflated DICOM file %1 inflates to more than 1 GiB; decompress it with another tool.</source>
        <translation>Die gepackte DICOM-Datei %1 ergibt mehr als 1&#xa0;GiB; entpacken Sie sie mit einem anderen Werkzeug.</translation>
    </message>
    <message>
        <source>The deflated DICOM file %1 is damaged: its data cannot be inflated; copy it again.</source>
        <translation>Die gepackte DICOM-Datei %1 ist beschädigt: Die Daten lassen sich nicht entpacken; kopieren Sie sie neu.</translation>
    </message>
    <message>
        <source>The DICOM header of %1 %2: the file is damaged or cut off; copy it again from its source.</source>
        <translation>Der DICOM-Header von %1 %2: Die Datei ist beschädigt oder abgeschnitten; kopieren Sie sie neu von ihrer Quelle.</translation>
    </message>
    <message>
        <source>names a value longer than the file</source>
        <translation>nennt einen Wert, der länger ist als die Datei</translation>
    </message>
    <message>
        <source>holds more than any header</source>
        <translation>enthält mehr als jeder Header</translation>
    </message>
    <message>
        <source>nests sequences too deeply</source>
        <translation>schachtelt Sequenzen zu tief</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>lässt sich nicht bis zum Ende lesen</translation>
    </message>
    <message>
        <source>has a broken fragment</source>
        <translation>hat ein beschädigtes Fragment</translation>
    </message>
    <message>
        <source>names a sequence longer than the file</source>
        <translation>nennt eine Sequenz, die länger ist als die Datei</translation>
    </message>
    <message>
        <source>has a sequence with a broken item</source>
        <translation>hat eine Sequenz mit einem beschädigten Element</translation>
    </message>
    <message>
        <source>has an item longer than its sequence</source>
        <translation>hat ein Element, das länger ist als seine Sequenz</translation>
    </message>
    <message>
        <source>The file %1 does not start as DICOM does; if it was an image, it is damaged or cut off, so copy it again from its source.</source>
        <translation>Die Datei %1 beginnt nicht wie DICOM; wenn sie ein Bild war, ist sie beschädigt oder abgeschnitten; kopieren Sie sie neu von ihrer Quelle.</translation>
    </message>
    <message>
        <source>The file %1 cannot be opened; check that it exists and that you may read it.</source>
        <translation>Die Datei %1 lässt sich nicht öffnen; prüfen Sie, ob es sie gibt und ob Sie sie lesen dürfen.</translation>
    </message>
    <message>
        <source>The DICOM file %1 %2</source>
        <translation>Die DICOM-Datei %1 %2</translation>
    </message>
    <message>
        <source>is the index of a medium (DICOMDIR) and no image; open the folder that holds it.</source>
        <translation>ist das Verzeichnis eines Datenträgers (DICOMDIR) und kein Bild; öffnen Sie den Ordner, in dem sie liegt.</translation>
    </message>
    <message>
        <source>is cut off before its picture; copy it again from its source.</source>
        <translation>ist vor ihrem Bild abgeschnitten; kopieren Sie sie neu von ihrer Quelle.</translation>
    </message>
    <message>
        <source>holds no image%1; open the folder of an image series instead.</source>
        <translation>enthält kein Bild%1; öffnen Sie stattdessen den Ordner einer Bildserie.</translation>
    </message>
    <message>
        <source> (its kind is %1)</source>
        <translation> (ihre Art ist %1)</translation>
    </message>
    <message>
        <source>stores its pixels as floating-point numbers, which this program does not read from DICOM; convert it to NIfTI.</source>
        <translation>speichert ihre Pixel als Gleitkommazahlen, die dieses Programm aus DICOM nicht liest; wandeln Sie sie in NIfTI um.</translation>
    </message>
    <message>
        <source>is a mosaic: many slices tiled in one picture; convert it with dcm2niix first.</source>
        <translation>ist ein Mosaik: viele Schichten in einem Bild; wandeln Sie sie zuerst mit dcm2niix um.</translation>
    </message>
    <message>
        <source>gives %1 as its number of frames; its header is damaged.</source>
        <translation>nennt %1 als Zahl ihrer Bilder; ihr Header ist beschädigt.</translation>
    </message>
    <message>
        <source>is a film: its frames follow each other in time and not in space, so they make no volume.</source>
        <translation>ist ein Film: Die Bilder folgen in der Zeit und nicht im Raum aufeinander, deshalb ergeben sie kein Volumen.</translation>
    </message>
    <message>
        <source>is a video, whose frames make no volume; export the series as single images.</source>
        <translation>ist ein Video, dessen Bilder kein Volumen ergeben; exportieren Sie die Serie als einzelne Bilder.</translation>
    </message>
    <message>
        <source>only names a server that holds its pixels (JPIP); export the images themselves.</source>
        <translation>nennt nur einen Server, der ihre Pixel hat (JPIP); exportieren Sie die Bilder selbst.</translation>
    </message>
    <message>
        <source>says its picture is %1 × %2 pixels; its header is damaged.</source>
        <translation>nennt als Bildgröße %1 × %2 Pixel; ihr Header ist beschädigt.</translation>
    </message>
    <message>
        <source>stores %1 bits per pixel, which this program does not read; convert it to 8, 16 or 32 bits.</source>
        <translation>speichert %1 Bit je Pixel, was dieses Programm nicht liest; wandeln Sie sie in 8, 16 oder 32 Bit um.</translation>
    </message>
    <message>
        <source>contradicts itself: %1 bits up to bit %2 stored in %3; its header is damaged.</source>
        <translation>widerspricht sich: %1 Bit bis zum Bit %2, gespeichert in %3; ihr Header ist beschädigt.</translation>
    </message>
    <message>
        <source>has %1 samples per pixel; only grey (1) and colour (3) can be opened.</source>
        <translation>hat %1 Werte je Pixel; nur Grau (1) und Farbe (3) lassen sich öffnen.</translation>
    </message>
    <message>
        <source>says its %1 samples per pixel mean %2, which this program does not know; export it as grey values.</source>
        <translation>nennt als Bedeutung ihrer %1 Werte je Pixel %2, was dieses Programm nicht kennt; exportieren Sie sie als Grauwerte.</translation>
    </message>
    <message>
        <source>is coloured by a palette this program cannot read; export it as grey values.</source>
        <translation>ist durch eine Palette gefärbt, die dieses Programm nicht lesen kann; exportieren Sie sie als Grauwerte.</translation>
    </message>
    <message>
        <source>stores uncompressed colour with reduced resolution (%1), which this program does not read; export it as grey values.</source>
        <translation>speichert unkomprimierte Farbe in verringerter Auflösung (%1), was dieses Programm nicht liest; exportieren Sie sie als Grauwerte.</translation>
    </message>
    <message>
        <source>is too short for the %1 pictures of %2 × %3 pixels it announces; it is damaged or cut off, so copy it again from its source.</source>
        <translation>ist zu kurz für die %1 Bilder von %2 × %3 Pixeln, die sie ankündigt; sie ist beschädigt oder abgeschnitten, kopieren Sie sie deshalb neu von ihrer Quelle.</translation>
    </message>
    <message>
        <source>announces %1 pictures, more than any volume has; export it again.</source>
        <translation>kündigt %1 Bilder an, mehr, als ein Volumen hat; exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>is cut off: its pixels need %1 bytes, and it holds %2; copy it again from its source.</source>
        <translation>ist abgeschnitten: Die Pixel brauchen %1 Byte, die Datei enthält %2; kopieren Sie sie neu von ihrer Quelle.</translation>
    </message>
    <message>
        <source>The compressed pixels of %1 %2 (transfer syntax %3); export the series uncompressed.</source>
        <translation>Die komprimierten Pixel von %1 %2 (Transfersyntax %3); exportieren Sie die Serie unkomprimiert.</translation>
    </message>
    <message>
        <source>are damaged or in a form this program does not read</source>
        <translation>sind beschädigt oder in einer Form, die dieses Programm nicht liest</translation>
    </message>
    <message>
        <source>make a picture of %1 × %2 pixels where the header says %3 × %4</source>
        <translation>ergeben ein Bild von %1 × %2 Pixeln, wo der Header %3 × %4 nennt</translation>
    </message>
    <message>
        <source>have %1 samples per pixel where the header says %2</source>
        <translation>haben %1 Werte je Pixel, wo der Header %2 nennt</translation>
    </message>
    <message>
        <source>have %1 bits where the header says %2</source>
        <translation>haben %1 Bit, wo der Header %2 nennt</translation>
    </message>
    <message>
        <source>are damaged or cut off (%1)</source>
        <translation>sind beschädigt oder abgeschnitten (%1)</translation>
    </message>
    <message>
        <source>do not fill the picture</source>
        <translation>füllen das Bild nicht</translation>
    </message>
    <message>
        <source>cannot be decoded, for they are damaged or in a form this program does not read</source>
        <translation>lassen sich nicht dekodieren, denn sie sind beschädigt oder in einer Form, die dieses Programm nicht liest</translation>
    </message>
    <message>
        <source>are in a form this program does not read</source>
        <translation>sind in einer Form, die dieses Programm nicht liest</translation>
    </message>
    <message>
        <source>are cut off</source>
        <translation>sind abgeschnitten</translation>
    </message>
    <message>
        <source>cannot be decoded: %1</source>
        <translation>lassen sich nicht dekodieren: %1</translation>
    </message>
    <message>
        <source>The pixels of the DICOM file %1 %2; the file is damaged or cut off, so copy it again from its source.</source>
        <translation>Die Pixel der DICOM-Datei %1 %2; die Datei ist beschädigt oder abgeschnitten, kopieren Sie sie deshalb neu von ihrer Quelle.</translation>
    </message>
    <message>
        <source>end early</source>
        <translation>enden vorzeitig</translation>
    </message>
    <message>
        <source>have a broken fragment</source>
        <translation>haben ein beschädigtes Fragment</translation>
    </message>
    <message>
        <source>hold %1 compressed pieces for %2 frames</source>
        <translation>enthalten %1 komprimierte Stücke für %2 Bilder</translation>
    </message>
    <message>
        <source>hold %1 pictures for %2 frames</source>
        <translation>enthalten %1 Bilder statt der %2 angekündigten</translation>
    </message>
    <message>
        <source>The DICOM series has a gap of %1 mm after slice %2, where its slices usually lie %3 mm apart: slices are missing; copy the whole series again.</source>
        <translation>Die DICOM-Serie hat eine Lücke von %1&#xa0;mm nach Schicht %2, während ihre Schichten sonst %3&#xa0;mm auseinanderliegen: Es fehlen Schichten; kopieren Sie die ganze Serie neu.</translation>
    </message>
    <message>
        <source>%1 and %2 mm</source>
        <translation>%1 und %2&#xa0;mm</translation>
    </message>
    <message>
        <source>%1 and in %2 more places</source>
        <translation>%1 und an %2 weiteren Stellen</translation>
    </message>
    <message>
        <source>%1 slice seems to be missing between %2 from the first</source>
        <translation>%1 Schicht scheint zwischen %2 (ab der ersten gemessen) zu fehlen</translation>
    </message>
    <message>
        <source>%1 slices seem to be missing between %2 from the first</source>
        <translation>%1 Schichten scheinen zwischen %2 (ab der ersten gemessen) zu fehlen</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 bis %2&#xa0;mm</translation>
    </message>
    <message>
        <source>The slices lie %1 apart; %2 mm is used for all, which moves a slice by %3 mm at most.</source>
        <translation>Die Schichten liegen %1 auseinander; für alle wird %2&#xa0;mm verwendet, was eine Schicht um höchstens %3&#xa0;mm verschiebt.</translation>
    </message>
    <message>
        <source>The slices lie unequally, %1 apart: %2 planes every %3 mm were interpolated between them, some of which %4</source>
        <translation>Die Schichten liegen ungleich, %1 auseinander: Dazwischen wurden %2 Ebenen im Abstand von %3&#xa0;mm interpoliert, von denen einige %4</translation>
    </message>
    <message>
        <source>may bridge missing slices.</source>
        <translation>vielleicht fehlende Schichten überbrücken.</translation>
    </message>
    <message>
        <source>bridge missing slices: %1.</source>
        <translation>fehlende Schichten überbrücken: %1.</translation>
    </message>
    <message>
        <source>The slices are stacked straight although they lie up to %1 mm sideways of each other.</source>
        <translation>Die Schichten werden gerade gestapelt, obwohl sie bis zu %1&#xa0;mm seitlich versetzt liegen.</translation>
    </message>
    <message>
        <source>The slices of the DICOM series lie beside each other rather than on each other, so they make no volume; choose another series.</source>
        <translation>Die Schichten der DICOM-Serie liegen nebeneinander statt aufeinander und ergeben kein Volumen; wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>The series does not say how thick its slices are; 1 mm is assumed.</source>
        <translation>Die Serie gibt nicht an, wie dick ihre Schichten sind; es wird 1&#xa0;mm angenommen.</translation>
    </message>
    <message>
        <source>The series does not say how large its pixels are; 1 mm is assumed.</source>
        <translation>Die Serie gibt nicht an, wie groß ihre Pixel sind; es wird 1&#xa0;mm angenommen.</translation>
    </message>
    <message>
        <source>The image does not say where it lies in the patient; its orientation is unknown.</source>
        <translation>Das Bild gibt nicht an, wo es im Patienten liegt; seine Orientierung ist unbekannt.</translation>
    </message>
    <message>
        <source>The images do not say where they lie in the patient: they are stacked in the order of their numbers, and the orientation is unknown.</source>
        <translation>Die Bilder geben nicht an, wo sie im Patienten liegen: Sie werden in der Reihenfolge ihrer Nummern gestapelt, und die Orientierung ist unbekannt.</translation>
    </message>
    <message>
        <source>temporal position</source>
        <translation>Zeitposition</translation>
    </message>
    <message>
        <source>trigger time</source>
        <translation>Triggerzeit</translation>
    </message>
    <message>
        <source>delay after the heart beat</source>
        <translation>Verzögerung nach dem Herzschlag</translation>
    </message>
    <message>
        <source>echo time</source>
        <translation>Echozeit</translation>
    </message>
    <message>
        <source>diffusion b-value</source>
        <translation>b-Wert der Diffusion</translation>
    </message>
    <message>
        <source>image type</source>
        <translation>Bildtyp</translation>
    </message>
    <message>
        <source>acquisition number</source>
        <translation>Aufnahmenummer</translation>
    </message>
    <message>
        <source>acquisition time</source>
        <translation>Aufnahmezeit</translation>
    </message>
    <message>
        <source>content time</source>
        <translation>Inhaltszeit</translation>
    </message>
    <message>
        <source>unset</source>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <source>%1 %2 of %3</source>
        <translation>%1 %2 von %3</translation>
    </message>
    <message>
        <source>the first %1 at each position</source>
        <translation>an jeder Position das erste nach %1</translation>
    </message>
    <message>
        <source>%1 image is a copy of another of the series and left out.</source>
        <translation>%1 Bild ist die Kopie eines anderen der Serie und wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 images are copies of another of the series and left out.</source>
        <translation>%1 Bilder sind Kopien anderer der Serie und wurden weggelassen.</translation>
    </message>
    <message>
        <source>the lowest image number at each position</source>
        <translation>die kleinste Bildnummer an jeder Position</translation>
    </message>
    <message>
        <source>The series holds several phases (%1 images at %2 positions); shown is: %3.</source>
        <translation>Die Serie enthält mehrere Phasen (%1 Bilder an %2 Positionen); gezeigt wird: %3.</translation>
    </message>
    <message>
        <source>The series repeats some positions (%1 images at %2 positions); shown is: %3.</source>
        <translation>Die Serie wiederholt einige Positionen (%1 Bilder an %2 Positionen); gezeigt wird: %3.</translation>
    </message>
    <message>
        <source>The folder %1 holds more than %2 files; open the folder of one study instead.</source>
        <translation>Der Ordner %1 enthält mehr als %2 Dateien; öffnen Sie stattdessen den Ordner einer Untersuchung.</translation>
    </message>
    <message>
        <source>check the name and the right to read it</source>
        <translation>prüfen Sie den Namen und das Leserecht</translation>
    </message>
    <message>
        <source>Cannot write %1: %2; check that the folder exists, may be written and has room.</source>
        <translation>%1 kann nicht geschrieben werden: %2; prüfen Sie, ob es den Ordner gibt, ob er beschreibbar ist und Platz hat.</translation>
    </message>
    <message>
        <source>its project list names no volume of three dimensions</source>
        <translation>ihre Projektliste nennt kein Volumen mit drei Dimensionen</translation>
    </message>
    <message>
        <source>open it in InVesalius and save it again</source>
        <translation>öffnen Sie sie in InVesalius, und speichern Sie sie neu</translation>
    </message>
    <message>
        <source>its voxels are of the type &quot;%1&quot;, which is not supported</source>
        <translation>ihre Voxel sind vom Typ „%1“, der nicht unterstützt wird</translation>
    </message>
    <message>
        <source>its matrix has %1 bytes where the project asks for %2</source>
        <translation>ihre Matrix hat %1 Byte, wo das Projekt %2 verlangt</translation>
    </message>
    <message>
        <source>its matrix &quot;%1&quot; is missing</source>
        <translation>ihre Matrix „%1“ fehlt</translation>
    </message>
    <message>
        <source>its archive is damaged or cut off</source>
        <translation>ihr Archiv ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>its archive holds gigabytes before the project</source>
        <translation>ihr Archiv enthält Gigabytes vor dem Projekt</translation>
    </message>
    <message>
        <source>its header&apos;s field %1 has too few numbers</source>
        <translation>das Feld %1 ihres Headers hat zu wenige Zahlen</translation>
    </message>
    <message>
        <source>it does not have 2 to 4 dimensions</source>
        <translation>sie hat nicht 2 bis 4 Dimensionen</translation>
    </message>
    <message>
        <source>save one volume of it</source>
        <translation>speichern Sie ein Volumen davon</translation>
    </message>
    <message>
        <source>its header has no DimSize</source>
        <translation>in ihrem Header fehlt DimSize</translation>
    </message>
    <message>
        <source>its header names no ElementDataFile</source>
        <translation>ihr Header nennt kein ElementDataFile</translation>
    </message>
    <message>
        <source>its header&apos;s HeaderSize is not supported</source>
        <translation>die HeaderSize ihres Headers wird nicht unterstützt</translation>
    </message>
    <message>
        <source>save it as one .mha file</source>
        <translation>speichern Sie sie als eine .mha-Datei</translation>
    </message>
    <message>
        <source>it holds compressed text</source>
        <translation>sie enthält komprimierten Text</translation>
    </message>
    <message>
        <source>save it uncompressed or as binary data</source>
        <translation>speichern Sie sie unkomprimiert oder als Binärdaten</translation>
    </message>
    <message>
        <source>its voxels are of NIfTI type %1 (binary, complex or 128-bit numbers are not supported)</source>
        <translation>ihre Voxel sind vom NIfTI-Typ %1 (binäre, komplexe oder 128-Bit-Zahlen werden nicht unterstützt)</translation>
    </message>
    <message>
        <source>convert it to integers or floats first</source>
        <translation>wandeln Sie sie zuerst in Ganz- oder Gleitkommazahlen um</translation>
    </message>
    <message>
        <source>it is an Analyze 7.5 file, which does not say which side is left</source>
        <translation>sie ist eine Datei von Analyze 7.5, die nicht angibt, welche Seite links ist</translation>
    </message>
    <message>
        <source>convert it to NIfTI (.nii) first</source>
        <translation>wandeln Sie sie zuerst in NIfTI (.nii) um</translation>
    </message>
    <message>
        <source>its NIfTI header is cut off or damaged</source>
        <translation>ihr NIfTI-Header ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>its header contradicts itself: voxels of %1 bits, and of a type that has %2</source>
        <translation>ihr Header widerspricht sich: Voxel von %1 Bit und von einem Typ, der %2 hat</translation>
    </message>
    <message>
        <source>its header places the voxels at an impossible offset</source>
        <translation>ihr Header legt die Voxel an eine unmögliche Stelle</translation>
    </message>
    <message>
        <source>The file&apos;s scaling is damaged: the values are those stored, in no known unit.</source>
        <translation>Die Skalierung der Datei ist beschädigt: Die Werte sind die gespeicherten, in keiner bekannten Einheit.</translation>
    </message>
    <message>
        <source>The file&apos;s two placements (sform, qform) differ by up to %1 mm; the sform is used.</source>
        <translation>Die beiden Lagen der Datei (sform, qform) weichen um bis zu %1&#xa0;mm voneinander ab; sform wird verwendet.</translation>
    </message>
    <message>
        <source>The file&apos;s placement (sform) is damaged and was left out.</source>
        <translation>Die Lage der Datei (sform) ist beschädigt und wurde weggelassen.</translation>
    </message>
    <message>
        <source>The file&apos;s placement (qform) is damaged and was left out.</source>
        <translation>Die Lage der Datei (qform) ist beschädigt und wurde weggelassen.</translation>
    </message>
    <message>
        <source>its header has a damaged list of vectors</source>
        <translation>ihr Header hat eine beschädigte Liste von Vektoren</translation>
    </message>
    <message>
        <source>its space does not have two or three dimensions</source>
        <translation>ihr Raum hat nicht zwei oder drei Dimensionen</translation>
    </message>
    <message>
        <source>convert it to a 3-D volume first</source>
        <translation>wandeln Sie sie zuerst in ein 3D-Volumen um</translation>
    </message>
    <message>
        <source>its header&apos;s field &quot;%1&quot; does not fit its dimension</source>
        <translation>das Feld „%1“ ihres Headers passt nicht zu ihrer Dimension</translation>
    </message>
    <message>
        <source>its header&apos;s dimension and sizes do not agree</source>
        <translation>Dimension und Größen ihres Headers stimmen nicht überein</translation>
    </message>
    <message>
        <source>its header does not say which of its axes are spatial</source>
        <translation>ihr Header gibt nicht an, welche ihrer Achsen räumlich sind</translation>
    </message>
    <message>
        <source>add the field &quot;kinds&quot; to the header or save one volume</source>
        <translation>ergänzen Sie im Header das Feld „kinds“, oder speichern Sie ein Volumen</translation>
    </message>
    <message>
        <source>its header gives more volumes than any file holds</source>
        <translation>ihr Header nennt mehr Volumen, als eine Datei enthält</translation>
    </message>
    <message>
        <source>its axis %1 holds %2 values per voxel (%3), and a volume needs one</source>
        <translation>ihre Achse %1 enthält %2 Werte je Voxel (%3), und ein Volumen braucht einen</translation>
    </message>
    <message>
        <source>no kind</source>
        <translation>keine Art</translation>
    </message>
    <message>
        <source>save one component or one time step as a volume of its own</source>
        <translation>speichern Sie eine Komponente oder einen Zeitschritt als eigenes Volumen</translation>
    </message>
    <message>
        <source>its axes are not those of one volume</source>
        <translation>ihre Achsen sind nicht die eines Volumens</translation>
    </message>
    <message>
        <source>save one scalar volume</source>
        <translation>speichern Sie ein skalares Volumen</translation>
    </message>
    <message>
        <source>its header does not name the byte order</source>
        <translation>ihr Header nennt die Bytereihenfolge nicht</translation>
    </message>
    <message>
        <source>add &quot;endian: little&quot; or &quot;endian: big&quot;</source>
        <translation>ergänzen Sie „endian: little“ oder „endian: big“</translation>
    </message>
    <message>
        <source>it ends before its voxels start</source>
        <translation>sie endet, bevor ihre Voxel beginnen</translation>
    </message>
    <message>
        <source>its header&apos;s byte skip is not supported</source>
        <translation>das „byte skip“ ihres Headers wird nicht unterstützt</translation>
    </message>
    <message>
        <source>save it as one .nrrd file</source>
        <translation>speichern Sie sie als eine .nrrd-Datei</translation>
    </message>
    <message>
        <source>its encoding &quot;%1&quot; is not supported</source>
        <translation>ihre Kodierung „%1“ wird nicht unterstützt</translation>
    </message>
    <message>
        <source>save it with the encoding raw or gzip</source>
        <translation>speichern Sie sie mit der Kodierung raw oder gzip</translation>
    </message>
    <message>
        <source>its NRRD header has no end</source>
        <translation>ihr NRRD-Header hat kein Ende</translation>
    </message>
    <message>
        <source>the picture is damaged or cut off</source>
        <translation>das Bild ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>its samples are of a type that is not supported</source>
        <translation>ihre Pixelwerte sind von einem Typ, der nicht unterstützt wird</translation>
    </message>
    <message>
        <source>convert it to 8 or 16 bits first</source>
        <translation>wandeln Sie sie zuerst in 8 oder 16 Bit um</translation>
    </message>
    <message>
        <source>the picture is cut off</source>
        <translation>das Bild ist abgeschnitten</translation>
    </message>
    <message>
        <source>its header asks for more pixels than the file can hold</source>
        <translation>ihr Header verlangt mehr Pixel, als die Datei enthalten kann</translation>
    </message>
    <message>
        <source>its picture %1 (page %2) has another size or type than the first</source>
        <translation>ihr Bild %1 (Seite %2) hat eine andere Größe oder einen anderen Typ als das erste</translation>
    </message>
    <message>
        <source>keep only the slices of one stack in the folder</source>
        <translation>lassen Sie nur die Schichten eines Stapels im Ordner</translation>
    </message>
    <message>
        <source>%1, so that a slice is missing from the stack</source>
        <translation>%1, sodass im Stapel eine Schicht fehlt</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>it does not start as a picture does</source>
        <translation>sie beginnt nicht wie ein Bild</translation>
    </message>
    <message>
        <source>copy it again, or take it out of the folder if it is no slice</source>
        <translation>kopieren Sie sie neu, oder nehmen Sie sie aus dem Ordner, wenn sie keine Schicht ist</translation>
    </message>
    <message>
        <source>its picture %1 has several pages</source>
        <translation>ihr Bild %1 hat mehrere Seiten</translation>
    </message>
    <message>
        <source>open that file by itself</source>
        <translation>öffnen Sie diese Datei für sich</translation>
    </message>
    <message>
        <source>it is a single picture, and a volume needs a stack of slices</source>
        <translation>sie ist ein einzelnes Bild, und ein Volumen braucht einen Stapel von Schichten</translation>
    </message>
    <message>
        <source>open the folder that holds all slices, or a TIFF file with several pages</source>
        <translation>öffnen Sie den Ordner mit allen Schichten oder eine TIFF-Datei mit mehreren Seiten</translation>
    </message>
    <message>
        <source>it holds pictures of several kinds</source>
        <translation>er enthält Bilder verschiedener Art</translation>
    </message>
    <message>
        <source>JPEG compression is lossy: the values are not the original ones.</source>
        <translation>Die JPEG-Komprimierung ist verlustbehaftet: Die Werte sind nicht die ursprünglichen.</translation>
    </message>
    <message>
        <source>The numbers in the file names are uneven: slices may be missing.</source>
        <translation>Die Nummern in den Dateinamen haben Lücken: Es können Schichten fehlen.</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>das Bild ist beschädigt</translation>
    </message>
    <message>
        <source>the picture is damaged (%1)</source>
        <translation>das Bild ist beschädigt (%1)</translation>
    </message>
    <message>
        <source>it holds %1 values per pixel of a kind that is not supported</source>
        <translation>sie enthält %1 Werte je Pixel einer Art, die nicht unterstützt wird</translation>
    </message>
    <message>
        <source>convert it to grey or RGB first</source>
        <translation>wandeln Sie sie zuerst in Grau oder RGB um</translation>
    </message>
    <message>
        <source>its pages are damaged or cut off</source>
        <translation>ihre Seiten sind beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>its header places the voxels with numbers that span no volume</source>
        <translation>ihr Header legt die Voxel mit Zahlen fest, die kein Volumen aufspannen</translation>
    </message>
    <message>
        <source>export the file again with a valid orientation</source>
        <translation>exportieren Sie die Datei neu mit einer gültigen Orientierung</translation>
    </message>
    <message>
        <source>its axes are sheared (%1 degrees off the right angle), which would be drawn distorted</source>
        <translation>ihre Achsen sind geschert (%1 Grad Abweichung vom rechten Winkel) und würden verzerrt gezeichnet</translation>
    </message>
    <message>
        <source>resample it to a rectangular grid first, e.g. with 3D Slicer or FSL</source>
        <translation>rechnen Sie sie zuerst auf ein rechtwinkliges Gitter um, z. B. mit 3D Slicer oder FSL</translation>
    </message>
    <message>
        <source>its compressed data are damaged</source>
        <translation>ihre komprimierten Daten sind beschädigt</translation>
    </message>
    <message>
        <source>its header asks for %1 bytes of voxels, but the file holds only %2%3</source>
        <translation>ihr Header verlangt %1 Byte an Voxeln, aber die Datei enthält nur %2%3</translation>
    </message>
    <message>
        <source> compressed ones</source>
        <translation> komprimierte</translation>
    </message>
    <message>
        <source>its voxels end early</source>
        <translation>ihre Voxel enden vorzeitig</translation>
    </message>
    <message>
        <source>The file holds more data than its header asks for: its dimensions may be wrong.</source>
        <translation>Die Datei enthält mehr Daten, als ihr Header verlangt: Vielleicht sind die Abmessungen falsch.</translation>
    </message>
    <message>
        <source>a voxel&apos;s text is not a number of the type that the header names</source>
        <translation>der Text eines Voxels ist keine Zahl des Typs, den der Header nennt</translation>
    </message>
    <message>
        <source>it holds colours as text</source>
        <translation>sie enthält Farben als Text</translation>
    </message>
    <message>
        <source>convert it to a binary encoding</source>
        <translation>wandeln Sie sie in eine binäre Kodierung um</translation>
    </message>
    <message>
        <source>The text ends right behind its last number, which may be cut off.</source>
        <translation>Der Text endet gleich hinter seiner letzten Zahl, die abgeschnitten sein kann.</translation>
    </message>
    <message>
        <source>The file ends before the last of its volumes: it may be cut off.</source>
        <translation>Die Datei endet vor dem letzten ihrer Volumen: Sie ist vielleicht abgeschnitten.</translation>
    </message>
    <message>
        <source>its voxels end after %1 of the %2 that its header asks for</source>
        <translation>ihre Voxel enden nach %1 der %2, die ihr Header verlangt</translation>
    </message>
    <message>
        <source>its header gives a dimension that is not a positive whole number</source>
        <translation>ihr Header nennt eine Abmessung, die keine positive ganze Zahl ist</translation>
    </message>
    <message>
        <source>it holds %1 values per voxel, and a volume needs one</source>
        <translation>sie enthält %1 Werte je Voxel, und ein Volumen braucht einen</translation>
    </message>
    <message>
        <source>save one component as a volume of its own</source>
        <translation>speichern Sie eine Komponente als eigenes Volumen</translation>
    </message>
    <message>
        <source>The file holds %1 volumes; the first is shown.</source>
        <translation>Die Datei enthält %1 Volumen; das erste wird gezeigt.</translation>
    </message>
    <message>
        <source>The file holds colours; their luminance is shown.</source>
        <translation>Die Datei enthält Farben; ihre Helligkeit wird gezeigt.</translation>
    </message>
    <message>
        <source>its header names no SCALARS among its first lines</source>
        <translation>ihr Header nennt in den ersten Zeilen keine SCALARS</translation>
    </message>
    <message>
        <source>export it as structured points with scalars</source>
        <translation>exportieren Sie sie als strukturierte Punkte mit Skalaren</translation>
    </message>
    <message>
        <source>its header&apos;s line SCALARS is cut off</source>
        <translation>die Zeile SCALARS ihres Headers ist abgeschnitten</translation>
    </message>
    <message>
        <source>its header contradicts itself: %1 %2 where DIMENSIONS make %3</source>
        <translation>ihr Header widerspricht sich: %1 %2, wo DIMENSIONS %3 ergeben</translation>
    </message>
    <message>
        <source>it holds no image data (STRUCTURED_POINTS)</source>
        <translation>sie enthält keine Bilddaten (STRUCTURED_POINTS)</translation>
    </message>
    <message>
        <source>export the volume as image data (.vti)</source>
        <translation>exportieren Sie das Volumen als Bilddaten (.vti)</translation>
    </message>
    <message>
        <source>its array of values is damaged or cut off</source>
        <translation>ihr Wertefeld ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>it holds VTK data of the type &quot;%1&quot;, not image data</source>
        <translation>sie enthält VTK-Daten vom Typ „%1“, keine Bilddaten</translation>
    </message>
    <message>
        <source>its text is cut off or damaged</source>
        <translation>ihr Text ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>its attribute %1 has the wrong number of numbers</source>
        <translation>ihr Attribut %1 hat die falsche Anzahl von Zahlen</translation>
    </message>
    <message>
        <source>its header has no WholeExtent</source>
        <translation>in ihrem Header fehlt WholeExtent</translation>
    </message>
    <message>
        <source>its compression %1 is not supported</source>
        <translation>ihre Komprimierung %1 wird nicht unterstützt</translation>
    </message>
    <message>
        <source>save it with ZLib or uncompressed</source>
        <translation>speichern Sie sie mit ZLib oder unkomprimiert</translation>
    </message>
    <message>
        <source>its text is too short for the voxels that its header asks for</source>
        <translation>ihr Text ist zu kurz für die Voxel, die ihr Header verlangt</translation>
    </message>
    <message>
        <source>its array of values is missing</source>
        <translation>ihr Wertefeld fehlt</translation>
    </message>
    <message>
        <source>its array of values lies behind the end of the file</source>
        <translation>ihr Wertefeld liegt hinter dem Ende der Datei</translation>
    </message>
    <message>
        <source>it holds no array of values</source>
        <translation>sie enthält kein Wertefeld</translation>
    </message>
    <message>
        <source>export the volume with its scalars</source>
        <translation>exportieren Sie das Volumen mit seinen Skalaren</translation>
    </message>
    <message>
        <source>its appended data are missing</source>
        <translation>ihre angehängten Daten fehlen</translation>
    </message>
    <message>
        <source>Cannot write %1: its ending names no picture format; use .png, .tif, .jpg or .exr.</source>
        <translation>%1 kann nicht geschrieben werden: Die Endung nennt kein Bildformat; verwenden Sie .png, .tif, .jpg oder .exr.</translation>
    </message>
    <message>
        <source>Cannot write %1: the picture or its description is too large for JPEG; use .png.</source>
        <translation>%1 kann nicht geschrieben werden: Das Bild oder seine Beschreibung ist zu groß für JPEG; verwenden Sie .png.</translation>
    </message>
    <message>
        <source>Cannot write %1: the picture has no pixels.</source>
        <translation>%1 kann nicht geschrieben werden: Das Bild hat keine Pixel.</translation>
    </message>
    <message>
        <source>Cannot write %1: %2; choose another folder, ending or size.</source>
        <translation>%1 kann nicht geschrieben werden: %2; wählen Sie einen anderen Ordner, eine andere Endung oder Größe.</translation>
    </message>
    <message>
        <source>above %1 to %2</source>
        <translation>über %1 bis %2</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>any number</source>
        <translation>eine beliebige Zahl</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>muss eine Zahl sein</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>muss true oder false sein</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>muss ein Text in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>must be a list of three numbers</source>
        <translation>muss eine Liste von drei Zahlen sein</translation>
    </message>
    <message>
        <source>must be a list of two numbers</source>
        <translation>muss eine Liste von zwei Zahlen sein</translation>
    </message>
    <message>
        <source>it lies elsewhere than the volume</source>
        <translation>sie liegt anderswo als das Volumen</translation>
    </message>
    <message>
        <source>open the label map that belongs to this volume</source>
        <translation>öffnen Sie die Labelkarte, die zu diesem Volumen gehört</translation>
    </message>
    <message>
        <source>Pictures can be neither read nor written, because there is not enough memory for the part of Limn that does it; close other programs or allow Limn more memory.</source>
        <translation>Bilder lassen sich weder lesen noch schreiben, weil der Speicher für den Teil von Limn nicht reicht, der es tut; schließen Sie andere Programme, oder geben Sie Limn mehr Speicher.</translation>
    </message>
    <message>
        <source>Pictures can be neither read nor written, because a part of Limn cannot be loaded (%1); install Limn again.</source>
        <translation>Bilder lassen sich weder lesen noch schreiben, weil ein Teil von Limn nicht geladen werden kann (%1); installieren Sie Limn neu.</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>kein Grund angegeben</translation>
    </message>
    <message>
        <source>its voxels need %1 GiB of memory and this computer has %2</source>
        <translation>ihre Voxel brauchen %1&#xa0;GiB Speicher, und dieser Rechner hat %2</translation>
    </message>
    <message>
        <source>save a smaller volume</source>
        <translation>speichern Sie ein kleineres Volumen</translation>
    </message>
    <message>
        <source>its voxel spacing of %1 mm is damaged</source>
        <translation>ihr Voxelabstand von %1&#xa0;mm ist beschädigt</translation>
    </message>
    <message>
        <source>give the true one with --spacing X,Y,Z</source>
        <translation>geben Sie den wahren mit --spacing X,Y,Z an</translation>
    </message>
    <message>
        <source>its header places it %1 mm away, which is damage</source>
        <translation>ihr Header setzt sie %1&#xa0;mm weit weg und ist also beschädigt</translation>
    </message>
    <message>
        <source>its header has &quot;%1&quot; where a number is needed</source>
        <translation>ihr Header enthält „%1“, wo eine Zahl gebraucht wird</translation>
    </message>
    <message>
        <source>copy or export the file again</source>
        <translation>kopieren oder exportieren Sie die Datei neu</translation>
    </message>
    <message>
        <source>a list of ParaView&apos;s colour maps</source>
        <translation>eine Liste von Farbskalen aus ParaView</translation>
    </message>
    <message>
        <source>JSON of another program</source>
        <translation>JSON eines anderen Programms</translation>
    </message>
    <message>
        <source>a preset of Limn, which shows a volume but names none</source>
        <translation>ein Preset von Limn, das ein Volumen zeigt, aber keines nennt</translation>
    </message>
    <message>
        <source>Limn&apos;s own settings</source>
        <translation>die Einstellungsdatei von Limn selbst</translation>
    </message>
    <message>
        <source>markups of 3D Slicer</source>
        <translation>eine Datei mit Markierungen aus 3D Slicer</translation>
    </message>
    <message>
        <source>a file of 3D Slicer (volume rendering properties)</source>
        <translation>eine Datei von 3D Slicer (Einstellungen der Volumendarstellung)</translation>
    </message>
    <message>
        <source>an empty JSON object</source>
        <translation>ein leeres JSON-Objekt</translation>
    </message>
    <message>
        <source>JSON of another program (its first key is &quot;%1&quot;)</source>
        <translation>JSON eines anderen Programms (sein erster Schlüssel ist „%1“)</translation>
    </message>
    <message>
        <source>it is %1, not a scene or session that Limn saved</source>
        <translation>sie ist %1, keine Szene oder Sitzung, die Limn gespeichert hat</translation>
    </message>
    <message>
        <source>open the volume itself and choose a preset</source>
        <translation>öffnen Sie das Volumen selbst, und wählen Sie ein Preset</translation>
    </message>
    <message>
        <source>must be the number of a label</source>
        <translation>muss die Nummer eines Labels sein</translation>
    </message>
    <message>
        <source>The scene gives a weight to label %1, which %2 does not have; take the weight out or choose another label map.</source>
        <translation>Die Szene gewichtet das Label %1, das %2 nicht hat; nehmen Sie das Gewicht heraus, oder wählen Sie eine andere Labelkarte.</translation>
    </message>
    <message>
        <source>must name the smaller number first</source>
        <translation>muss die kleinere Zahl zuerst nennen</translation>
    </message>
    <message>
        <source>must be a list of control points</source>
        <translation>muss eine Liste von Punkten sein</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>must be &quot;auto&quot;, &quot;max&quot;, {&quot;percentile&quot;: p} or a number in value/mm</source>
        <translation>muss „auto“, „max“, {„percentile“: p} oder eine Zahl in Wert/mm sein</translation>
    </message>
    <message>
        <source>must not be smaller than that of the point before</source>
        <translation>darf nicht kleiner sein als beim Punkt davor</translation>
    </message>
    <message>
        <source>must be smaller than &quot;crop.upper&quot; on every axis</source>
        <translation>muss auf jeder Achse kleiner sein als „crop.upper“</translation>
    </message>
    <message>
        <source>needs a tolerance_levels beside it</source>
        <translation>braucht daneben ein tolerance_levels</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>must be three letters, one of L and R, one of P and A, one of S and I</source>
        <translation>muss aus drei Buchstaben bestehen: einem von L und R, einem von P und A, einem von S und I</translation>
    </message>
    <message>
        <source>must ascend: background, object, brightest</source>
        <translation>muss aufsteigen: background, object, brightest</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>settings file</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>must be a list of keys with texts</source>
        <translation>muss eine Liste von Schlüsseln mit Texten sein</translation>
    </message>
    <message>
        <source>it holds voxels without their size</source>
        <translation>sie enthält Voxel ohne deren Größe</translation>
    </message>
    <message>
        <source>open %1 instead</source>
        <translation>öffnen Sie stattdessen %1</translation>
    </message>
    <message>
        <source>it does not say the size and type of a volume in a way that Limn knows</source>
        <translation>sie nennt Größe und Typ eines Volumens nicht so, dass Limn es versteht</translation>
    </message>
    <message>
        <source>write a small MetaImage header (.mhd) that names the raw file beside it, and open that</source>
        <translation>schreiben Sie einen kleinen MetaImage-Header (.mhd), der die Rohdatei daneben nennt, und öffnen Sie diesen</translation>
    </message>
    <message>
        <source>it does not start as DICOM does: it is damaged or cut off</source>
        <translation>sie beginnt nicht wie DICOM: Sie ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>its content is of no known kind</source>
        <translation>ihr Inhalt ist von keiner bekannten Art</translation>
    </message>
    <message>
        <source>it is packed with gzip</source>
        <translation>sie ist mit gzip gepackt</translation>
    </message>
    <message>
        <source>unpack it and open the file inside</source>
        <translation>entpacken Sie sie, und öffnen Sie die Datei darin</translation>
    </message>
    <message>
        <source>the folder holds no DICOM, TIFF, PNG or JPEG slices</source>
        <translation>der Ordner enthält keine Schichten als DICOM, TIFF, PNG oder JPEG</translation>
    </message>
    <message>
        <source>open the folder that holds the slices, or a volume file</source>
        <translation>öffnen Sie den Ordner mit den Schichten oder eine Volumendatei</translation>
    </message>
    <message>
        <source>Spacing unknown: where the file does not give it, 1 mm is assumed; give it with --spacing X,Y,Z.</source>
        <translation>Voxelabstand unbekannt: Wo die Datei ihn nicht nennt, wird 1&#xa0;mm angenommen; geben Sie ihn mit --spacing X,Y,Z an.</translation>
    </message>
    <message>
        <source>it is no file but a device, pipe or socket</source>
        <translation>sie ist keine Datei, sondern ein Gerät, eine Pipe oder ein Socket</translation>
    </message>
    <message>
        <source>choose a file or folder</source>
        <translation>wählen Sie eine Datei oder einen Ordner</translation>
    </message>
    <message>
        <source>there is not enough memory for it</source>
        <translation>der Speicher reicht dafür nicht</translation>
    </message>
    <message>
        <source>close other programs or save a smaller volume</source>
        <translation>schließen Sie andere Programme, oder speichern Sie ein kleineres Volumen</translation>
    </message>
    <message>
        <source>its header asks for more voxels than memory can hold</source>
        <translation>ihr Header verlangt mehr Voxel, als der Speicher fasst</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>diese Datei oder diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>check the name</source>
        <translation>prüfen Sie den Namen</translation>
    </message>
    <message>
        <source>drawing a picture</source>
        <translation>beim Zeichnen eines Bildes</translation>
    </message>
    <message>
        <source>gradients in half floats</source>
        <translation>Gradienten in halber Genauigkeit</translation>
    </message>
    <message>
        <source>gradients in bytes</source>
        <translation>Gradienten in Byte</translation>
    </message>
    <message>
        <source>classified voxels</source>
        <translation>klassifizierte Voxel</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>nothing lies beside it</source>
        <translation>nichts liegt neben ihm</translation>
    </message>
    <message>
        <source>it holds no tissue</source>
        <translation>es enthält kein Gewebe</translation>
    </message>
    <message>
        <source>It is no label map: its values are no whole numbers; open a segmentation, not the image that it was made of.</source>
        <translation>Dies ist keine Labelkarte: Die Werte sind keine ganzen Zahlen; öffnen Sie eine Segmentierung, nicht das Bild, aus dem sie entstand.</translation>
    </message>
    <message>
        <source>It is no label map: it has more than 65535 different values; open a segmentation, not the image that it was made of.</source>
        <translation>Dies ist keine Labelkarte: Sie hat mehr als 65535 verschiedene Werte; öffnen Sie eine Segmentierung, nicht das Bild, aus dem sie entstand.</translation>
    </message>
    <message>
        <source>The transfer function&apos;s unit distance must be a positive number of millimetres.</source>
        <translation>Die Einheitsstrecke der Transferfunktion muss eine positive Zahl von Millimetern sein.</translation>
    </message>
    <message>
        <source>A control point of the transfer function holds a number that is not finite.</source>
        <translation>Ein Punkt der Transferfunktion enthält eine Zahl, die nicht endlich ist.</translation>
    </message>
    <message>
        <source>A label map has 1 to 65536 labels; this one has %1.</source>
        <translation>Eine Labelkarte hat 1 bis 65536 Labels; diese hat %1.</translation>
    </message>
    <message>
        <source>A label map has one label for each voxel; this one has %1 for %2.</source>
        <translation>Eine Labelkarte hat ein Label je Voxel; diese hat %1 für %2.</translation>
    </message>
    <message>
        <source>A voxel&apos;s label is missing in the list of labels.</source>
        <translation>Das Label eines Voxels fehlt in der Liste der Labels.</translation>
    </message>
    <message>
        <source>Orientation unknown: the file does not say which side is left.</source>
        <translation>Orientierung unbekannt: Die Datei gibt nicht an, welche Seite links ist.</translation>
    </message>
    <message>
        <source>The phantom cannot be made at this spacing; choose 0.2 to 20 mm.</source>
        <translation>Das Phantom lässt sich mit diesem Voxelabstand nicht erzeugen; wählen Sie 0,2 bis 20&#xa0;mm.</translation>
    </message>
    <message>
        <source>The volume holds no valid voxel: every value is NaN, infinite or declared padding; check that the right series was chosen.</source>
        <translation>Das Volumen enthält kein gültiges Voxel: Jeder Wert ist NaN, unendlich oder als Füllwert gekennzeichnet; prüfen Sie, ob die richtige Serie gewählt wurde.</translation>
    </message>
    <message>
        <source>The volume&apos;s values are not finite or beyond 1e300 after rescaling; its slope, its intercept or its voxels are damaged.</source>
        <translation>Die Werte des Volumens sind nach der Skalierung nicht endlich oder über 1e300; Steigung, Achsenabschnitt oder Voxel sind beschädigt.</translation>
    </message>
    <message>
        <source>The volume has no voxels along one axis.</source>
        <translation>Das Volumen hat entlang einer Achse keine Voxel.</translation>
    </message>
    <message>
        <source>The volume&apos;s voxel spacing is not a positive number; give it with --spacing X,Y,Z.</source>
        <translation>Der Voxelabstand des Volumens ist keine positive Zahl; geben Sie ihn mit --spacing X,Y,Z an.</translation>
    </message>
    <message>
        <source>The volume has %1 voxels where its dimensions ask for %2; the file is truncated or its header is wrong.</source>
        <translation>Das Volumen hat %1 Voxel, wo seine Abmessungen %2 verlangen; die Datei ist abgeschnitten, oder ihr Header ist falsch.</translation>
    </message>
    <message>
        <source>Slices cannot draw the projection &quot;%1&quot;, only composite and xray; use --engine gl or reference for it.</source>
        <translation>Schnitte können die Projektion „%1“ nicht zeichnen, nur composite und xray; verwenden Sie dafür --engine gl oder reference.</translation>
    </message>
    <message>
        <source>The step is so small that the volume would need more than %1 slices; it is drawn with that number.</source>
        <translation>Die Schritte sind so klein, dass das Volumen mehr als %1 Schnitte bräuchte; es wird mit dieser Zahl gezeichnet.</translation>
    </message>
    <message>
        <source>drawing a picture of slices</source>
        <translation>beim Zeichnen eines Bildes aus Schnitten</translation>
    </message>
    <message>
        <source>Cannot read %1: %2</source>
        <translation>%1 kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>%1; %2.</source>
        <translation>%1; %2.</translation>
    </message>
    <message>
        <source>Chosen in the settings.</source>
        <translation>In den Einstellungen gewählt.</translation>
    </message>
    <message>
        <source>Cannot write %1: a figure needs the ending .png, .tif, .exr or .pdf.</source>
        <translation>%1 kann nicht geschrieben werden: Eine Abbildung braucht die Endung .png, .tif, .exr oder .pdf.</translation>
    </message>
    <message>
        <source>Body only may be wrong here: %1; compare with everything shown.</source>
        <translation>„Nur Körper“ ist hier vielleicht falsch: %1; vergleichen Sie mit der Ansicht von allem.</translation>
    </message>
    <message>
        <source>The preset file %1 is left out: another preset is called &quot;%2&quot;; give it a name of its own.</source>
        <translation>Die Preset-Datei %1 wird ausgelassen: Ein anderes Preset heißt „%2“; geben Sie ihr einen eigenen Namen.</translation>
    </message>
    <message>
        <source>Cannot write %1: this picture needs the ending .png or .tif.</source>
        <translation>%1 kann nicht geschrieben werden: Dieses Bild braucht die Endung .png oder .tif.</translation>
    </message>
    <message>
        <source>only %1 of the tissue hangs together, so a part of the patient may be hidden</source>
        <translation>nur %1 des Gewebes hängen zusammen, deshalb ist vielleicht ein Teil des Patienten ausgeblendet</translation>
    </message>
    <message>
        <source>what lies against the body touches it by %1 of its surface, so a part of the table may be kept</source>
        <translation>was am Körper anliegt, berührt ihn auf %1 seiner Oberfläche, deshalb wird vielleicht ein Teil des Tisches behalten</translation>
    </message>
    <message>
        <source>≈ 0 ms</source>
        <translation>≈ 0&#xa0;ms</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made (%2); choose another one.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden (%2); wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>No video can be made, because ffmpeg is not installed; install the package ffmpeg or save frames into a folder.</source>
        <translation>Es kann kein Video erstellt werden, weil ffmpeg nicht installiert ist; installieren Sie das Paket ffmpeg, oder speichern Sie Einzelbilder in einen Ordner.</translation>
    </message>
    <message>
        <source>The video cannot be made (%1); choose another place, or a folder for the frames.</source>
        <translation>Das Video kann nicht erstellt werden (%1); wählen Sie einen anderen Ort oder einen Ordner für die Einzelbilder.</translation>
    </message>
    <message>
        <source>The frames of the video have no place (%1); make room in the folder for temporary files.</source>
        <translation>Für die Einzelbilder des Videos fehlt der Platz (%1); schaffen Sie Platz im Ordner für temporäre Dateien.</translation>
    </message>
    <message>
        <source>must be a list of 1 to %1 panels</source>
        <translation>muss eine Liste von 1 bis %1 Teilbildern sein</translation>
    </message>
    <message>
        <source>%1 has no look &quot;%2&quot;; it has: %3.</source>
        <translation>%1 hat keine Darstellung „%2“; vorhanden sind: %3.</translation>
    </message>
    <message>
        <source>Of its %1 looks the first, &quot;%2&quot;, was taken.</source>
        <translation>Von ihren %1 Darstellungen wurde die erste genommen, „%2“.</translation>
    </message>
    <message>
        <source>The look was fitted to the volume&apos;s values.</source>
        <translation>Die Darstellung wurde an die Werte des Volumens angepasst.</translation>
    </message>
    <message>
        <source>The format has 256 places for points: the values of some moved, by up to %1.</source>
        <translation>Das Format hat 256 Stellen für Punkte: Die Werte einiger haben sich verschoben, um bis zu %1.</translation>
    </message>
    <message>
        <source>The format has colours and opacities in 256 levels: some were rounded, by up to %1.</source>
        <translation>Das Format hat Farben und Deckkraft in 256 Stufen: Einige wurden gerundet, um bis zu %1.</translation>
    </message>
    <message>
        <source>its range of values ends before it begins</source>
        <translation>ihr Wertebereich endet, bevor er beginnt</translation>
    </message>
    <message>
        <source>the intensity of one of its points is not in 0..255</source>
        <translation>die Intensität eines ihrer Punkte liegt nicht in 0..255</translation>
    </message>
    <message>
        <source>%1 points lie closer together than the format can tell and were left out.</source>
        <translation>%1 Punkte liegen enger beieinander, als das Format unterscheidet, und wurden weggelassen.</translation>
    </message>
    <message>
        <source>its scale is logarithmic, but not all of its values are above 0</source>
        <translation>ihre Skala ist logarithmisch, aber nicht alle ihre Werte liegen über 0</translation>
    </message>
    <message>
        <source>save it with a linear scale</source>
        <translation>speichern Sie sie mit linearer Skala</translation>
    </message>
    <message>
        <source>a midpoint or sharpness in it is no number</source>
        <translation>ein Mittelpunkt oder eine Schärfe darin ist keine Zahl</translation>
    </message>
    <message>
        <source>Curved segments became straight ones that differ from them by at most %1.</source>
        <translation>Gebogene Abschnitte wurden zu geraden, die um höchstens %1 von ihnen abweichen.</translation>
    </message>
    <message>
        <source>straight segments for its curves need more than %1 points</source>
        <translation>gerade Abschnitte für ihre Kurven brauchen mehr als %1 Punkte</translation>
    </message>
    <message>
        <source>save it with fewer points</source>
        <translation>speichern Sie sie mit weniger Punkten</translation>
    </message>
    <message>
        <source>its row %1 does not have four numbers</source>
        <translation>ihre Zeile %1 hat nicht vier Zahlen</translation>
    </message>
    <message>
        <source>it has more than %1 rows</source>
        <translation>sie hat mehr als %1 Zeilen</translation>
    </message>
    <message>
        <source>save it with fewer rows</source>
        <translation>speichern Sie sie mit weniger Zeilen</translation>
    </message>
    <message>
        <source>it has %1 rows where it says another number</source>
        <translation>sie hat %1 Zeilen, nennt aber eine andere Anzahl</translation>
    </message>
    <message>
        <source>Its %1 rows became %2 points, within %3 of colour and opacity.</source>
        <translation>Ihre %1 Zeilen wurden zu %2 Punkten, auf %3 in Farbe und Deckkraft genau.</translation>
    </message>
    <message>
        <source>This format divides a volume&apos;s range of values into rows, and there is no volume; open or name the volume that it is for (--for VOLUME).</source>
        <translation>Dieses Format teilt den Wertebereich eines Volumens in Zeilen, und es gibt kein Volumen; öffnen oder nennen Sie das Volumen, für das es gedacht ist (--for VOLUME).</translation>
    </message>
    <message>
        <source>The curve became %1 rows from %2 to %3, which differ from it by up to %4.</source>
        <translation>Die Kurve wurde zu %1 Zeilen von %2 bis %3, die um bis zu %4 von ihr abweichen.</translation>
    </message>
    <message>
        <source>ImageVis3D table</source>
        <translation>Tabelle von ImageVis3D</translation>
    </message>
    <message>
        <source>its mask hides all values</source>
        <translation>ihre Maske verbirgt alle Werte</translation>
    </message>
    <message>
        <source>clear the mask in Inviwo and save it again</source>
        <translation>löschen Sie die Maske in Inviwo, und speichern Sie sie neu</translation>
    </message>
    <message>
        <source>Its mask became points, outside which the opacity is 0.</source>
        <translation>Ihre Maske wurde zu Punkten, außerhalb derer die Deckkraft 0 ist.</translation>
    </message>
    <message>
        <source>it is a file of Inviwo without a transfer function of its own</source>
        <translation>sie ist eine Datei von Inviwo ohne eigene Transferfunktion</translation>
    </message>
    <message>
        <source>save the transfer function alone (.itf) in Inviwo</source>
        <translation>speichern Sie in Inviwo die Transferfunktion allein (.itf)</translation>
    </message>
    <message>
        <source>Its points are joined by curves, which became straight lines.</source>
        <translation>Ihre Punkte sind durch Bögen verbunden, die zu Geraden wurden.</translation>
    </message>
    <message>
        <source>Inviwo transfer function</source>
        <translation>Transferfunktion von Inviwo</translation>
    </message>
    <message>
        <source>Limn preset</source>
        <translation>Preset von Limn</translation>
    </message>
    <message>
        <source>Only a DICOM series, or a scene of one, can be saved to DICOM, because picture and look are filed with its patient and study; open the series that %1 was made from.</source>
        <translation>Nur eine DICOM-Serie oder eine Szene davon lässt sich als DICOM speichern, weil Bild und Darstellung bei ihrem Patienten und ihrer Studie abgelegt werden; öffnen Sie die Serie, aus der %1 entstand.</translation>
    </message>
    <message>
        <source>The series that the look %1 belongs to is not beside it; say where it is (--volume PATH).</source>
        <translation>Die Serie, zu der die Darstellung %1 gehört, liegt nicht daneben; geben Sie an, wo sie ist (--volume PATH).</translation>
    </message>
    <message>
        <source>it is cropped, and %1 does not say how</source>
        <translation>sie ist zugeschnitten, und %1 sagt nicht, wie</translation>
    </message>
    <message>
        <source>it is cropped by specification %1, which is missing</source>
        <translation>sie ist nach Vorgabe %1 zugeschnitten, die fehlt</translation>
    </message>
    <message>
        <source>%1 is missing or damaged</source>
        <translation>%1 fehlt oder ist beschädigt</translation>
    </message>
    <message>
        <source>It is cropped by oblique planes, which Limn does not draw: what they cut away is shown.</source>
        <translation>Sie ist durch schräge Ebenen zugeschnitten, die Limn nicht zeichnet: Was sie abschneiden, ist zu sehen.</translation>
    </message>
    <message>
        <source>it is cropped by &quot;%1&quot;, which Limn cannot draw</source>
        <translation>sie ist durch „%1“ zugeschnitten, was Limn nicht zeichnen kann</translation>
    </message>
    <message>
        <source>export a look without segmentations</source>
        <translation>exportieren Sie eine Darstellung ohne Segmentierungen</translation>
    </message>
    <message>
        <source>export a look of one volume</source>
        <translation>exportieren Sie eine Darstellung eines einzelnen Volumens</translation>
    </message>
    <message>
        <source>it shows a segmented volume, whose parts Limn cannot colour separately</source>
        <translation>sie zeigt ein segmentiertes Volumen, dessen Teile Limn nicht einzeln färben kann</translation>
    </message>
    <message>
        <source>it shows several volumes together, which Limn cannot draw</source>
        <translation>sie zeigt mehrere Volumen zusammen, was Limn nicht zeichnen kann</translation>
    </message>
    <message>
        <source>it shows reformatted slices, not a volume</source>
        <translation>sie zeigt reformatierte Schichten, kein Volumen</translation>
    </message>
    <message>
        <source>it is no presentation state of a volume</source>
        <translation>sie ist kein Presentation State eines Volumens</translation>
    </message>
    <message>
        <source>The animation (%1) is not played.</source>
        <translation>Die Animation (%1) wird nicht abgespielt.</translation>
    </message>
    <message>
        <source>The annotations in the volume are not shown.</source>
        <translation>Die Beschriftungen im Volumen werden nicht gezeigt.</translation>
    </message>
    <message>
        <source>The annotations on the picture are not shown.</source>
        <translation>Die Beschriftungen auf dem Bild werden nicht gezeigt.</translation>
    </message>
    <message>
        <source>It does not say over which length its opacities hold (Sampling Step Size); they hold over 1 mm.</source>
        <translation>Sie sagt nicht, über welche Länge ihre Deckkraft gilt (Sampling Step Size); sie gilt über 1&#xa0;mm.</translation>
    </message>
    <message>
        <source>What the near plane cuts away is shown.</source>
        <translation>Was die nahe Ebene abschneidet, ist zu sehen.</translation>
    </message>
    <message>
        <source>What the far plane cuts away is shown.</source>
        <translation>Was die ferne Ebene abschneidet, ist zu sehen.</translation>
    </message>
    <message>
        <source>The crop leaves nothing of the volume; all of it is shown.</source>
        <translation>Der Zuschnitt lässt nichts vom Volumen übrig; es wird ganz gezeigt.</translation>
    </message>
    <message>
        <source>its window is given by a table, which Limn does not apply</source>
        <translation>ihre Fensterung ist durch eine Tabelle gegeben, die Limn nicht anwendet</translation>
    </message>
    <message>
        <source>export the look with a window of centre and width</source>
        <translation>exportieren Sie die Darstellung mit Fensterlage und Fensterbreite</translation>
    </message>
    <message>
        <source>its window has no centre, or a width that is none</source>
        <translation>ihre Fensterung hat keine Lage, oder eine Breite, die keine ist</translation>
    </message>
    <message>
        <source>The window&apos;s function %1 was read as a straight line.</source>
        <translation>Die Funktion %1 der Fensterung wurde als Gerade gelesen.</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 fehlt</translation>
    </message>
    <message>
        <source>it classifies its volume several times, which Limn cannot draw</source>
        <translation>sie klassifiziert ihr Volumen mehrmals, was Limn nicht zeichnen kann</translation>
    </message>
    <message>
        <source>its colours depend on two values at a time (TWO_TO_RGBA), which Limn cannot draw</source>
        <translation>ihre Farben hängen von je zwei Werten ab (TWO_TO_RGBA), was Limn nicht zeichnen kann</translation>
    </message>
    <message>
        <source>export a look whose colours depend on one</source>
        <translation>exportieren Sie eine Darstellung, deren Farben von einem abhängen</translation>
    </message>
    <message>
        <source>the kind of its colours, &quot;%1&quot;, is unknown</source>
        <translation>die Art ihrer Farben, „%1“, ist unbekannt</translation>
    </message>
    <message>
        <source>the tables of its colours and opacity differ in length or bits</source>
        <translation>die Tabellen ihrer Farben und Deckkraft unterscheiden sich in Länge oder Bits</translation>
    </message>
    <message>
        <source>its table has a single entry</source>
        <translation>ihre Tabelle hat einen einzigen Eintrag</translation>
    </message>
    <message>
        <source>the kind of its opacities, &quot;%1&quot;, is unknown</source>
        <translation>die Art ihrer Deckkraft, „%1“, ist unbekannt</translation>
    </message>
    <message>
        <source>it has neither a window nor a table</source>
        <translation>sie hat weder Fensterung noch Tabelle</translation>
    </message>
    <message>
        <source>%1 contradicts itself</source>
        <translation>%1 widerspricht sich</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;, which Limn does not know</source>
        <translation>%1 ist „%2“, was Limn nicht kennt</translation>
    </message>
    <message>
        <source>The field of view lies beside the axis of the view; it was centred.</source>
        <translation>Das Blickfeld liegt neben der Blickachse; es wurde auf sie gerückt.</translation>
    </message>
    <message>
        <source>its viewpoint is the point that it looks at</source>
        <translation>ihr Blickpunkt ist der Punkt, auf den sie blickt</translation>
    </message>
    <message>
        <source>The attribute %1 cannot be written; please report it.</source>
        <translation>Das Attribut %1 kann nicht geschrieben werden; bitte melden Sie es.</translation>
    </message>
    <message>
        <source>export the look again</source>
        <translation>exportieren Sie die Darstellung noch einmal</translation>
    </message>
    <message>
        <source>it belongs to another series: none of its %1 images is in %2</source>
        <translation>sie gehört zu einer anderen Serie: Keines ihrer %1 Bilder liegt in %2</translation>
    </message>
    <message>
        <source>name the folder of its series (--volume PATH)</source>
        <translation>geben Sie den Ordner ihrer Serie an (--volume PATH)</translation>
    </message>
    <message>
        <source>%1 of the %2 images that it belongs to are missing in %3</source>
        <translation>%1 der %2 Bilder, zu denen sie gehört, fehlen in %3</translation>
    </message>
    <message>
        <source>fetch the whole series again</source>
        <translation>holen Sie die ganze Serie noch einmal</translation>
    </message>
    <message>
        <source>The model is written as classic: exponents by gradient are not kept.</source>
        <translation>Das Modell wird als klassisch geschrieben: Exponenten nach dem Gradienten gehen verloren.</translation>
    </message>
    <message>
        <source>Opacity by gradient (O) is not kept: the curve&apos;s own opacity is written.</source>
        <translation>Die Deckkraft nach dem Gradienten (O) geht verloren: Geschrieben wird die der Kurve.</translation>
    </message>
    <message>
        <source>What robust adds (energy factor, significance, knee) is not kept: sums are clamped.</source>
        <translation>Was Robust hinzufügt (Energiefaktor, Signifikanz, Knie), geht verloren: Summen werden begrenzt.</translation>
    </message>
    <message>
        <source>Highlights are written as Phong&apos;s, with a quarter of the exponent of Blinn-Phong, as wide.</source>
        <translation>Glanzlichter werden als solche von Phong geschrieben, mit einem Viertel des Exponenten von Blinn-Phong, ebenso breit.</translation>
    </message>
    <message>
        <source>Highlights in the material&apos;s colour are not kept: they are white.</source>
        <translation>Glanzlichter in der Farbe des Materials gehen verloren: Sie sind weiß.</translation>
    </message>
    <message>
        <source>The headlight is written as parallel light along the view, so it no longer follows the camera, and towards the edges of the picture it differs.</source>
        <translation>Das Licht vom Betrachter wird als paralleles Licht in Blickrichtung geschrieben; es folgt der Kamera nicht mehr, und zum Bildrand hin weicht es ab.</translation>
    </message>
    <message>
        <source>The headlight is written as light along the view, so it no longer follows the camera.</source>
        <translation>Das Licht vom Betrachter wird als Licht in Blickrichtung geschrieben; es folgt der Kamera nicht mehr.</translation>
    </message>
    <message>
        <source>Coefficients times intensity above 1 are limited to 1.</source>
        <translation>Koeffizient mal Intensität über 1 wird auf 1 begrenzt.</translation>
    </message>
    <message>
        <source>The curve is written as a table of %1 entries over the values of the volume.</source>
        <translation>Die Kurve wird als Tabelle von %1 Einträgen über die Werte des Volumens geschrieben.</translation>
    </message>
    <message>
        <source>The unit distance of %1 mm is not kept: opacities are written over the step of %2 mm.</source>
        <translation>Die Einheitslänge von %1&#xa0;mm geht verloren: Die Deckkraft wird über den Schritt von %2&#xa0;mm geschrieben.</translation>
    </message>
    <message>
        <source>The gradient opacity is not kept.</source>
        <translation>Die Deckkraftkurve über dem Gradienten geht verloren.</translation>
    </message>
    <message>
        <source>The average is not kept: the look is a composite.</source>
        <translation>Der Mittelwert geht verloren: Die Darstellung ist ein Composite.</translation>
    </message>
    <message>
        <source>The X-ray is not kept: the look is a composite.</source>
        <translation>Das Röntgenbild geht verloren: Die Darstellung ist ein Composite.</translation>
    </message>
    <message>
        <source>The isosurface is not kept: the look is a composite.</source>
        <translation>Die Isofläche geht verloren: Die Darstellung ist ein Composite.</translation>
    </message>
    <message>
        <source>The fog is not kept.</source>
        <translation>Der Nebel geht verloren.</translation>
    </message>
    <message>
        <source>That the body alone is kept is lost: table and holder are shown.</source>
        <translation>Dass allein der Körper bleibt, geht verloren: Tisch und Kopfhalterung sind zu sehen.</translation>
    </message>
    <message>
        <source>The kept labels are lost, for Limn as well: a look names no label map; save the scene beside it.</source>
        <translation>Die behaltenen Labels gehen verloren, auch für Limn: Eine Darstellung nennt keine Segmentierung; speichern Sie die Szene daneben.</translation>
    </message>
    <message>
        <source>The error wished for is not kept: steps are equal.</source>
        <translation>Der gewünschte Fehler geht verloren: Die Schritte sind gleich.</translation>
    </message>
    <message>
        <source>The jitter is not kept.</source>
        <translation>Das Verwackeln (Jitter) geht verloren.</translation>
    </message>
    <message>
        <source>That the curve is pre-integrated is not kept.</source>
        <translation>Dass die Kurve vorintegriert wird, geht verloren.</translation>
    </message>
    <message>
        <source>Where rays end early is left to the program that draws.</source>
        <translation>Wo Strahlen früh enden, bleibt dem Programm überlassen, das zeichnet.</translation>
    </message>
    <message>
        <source>The background is not kept.</source>
        <translation>Der Hintergrund geht verloren.</translation>
    </message>
    <message>
        <source>Of the picture&apos;s size only the shape is kept, not its pixels.</source>
        <translation>Von der Bildgröße bleibt nur die Form, nicht die Pixelzahl.</translation>
    </message>
    <message>
        <source>The near plane lies just before the eye, which is within the volume or beside it.</source>
        <translation>Die nahe Ebene liegt dicht vor dem Auge, das im Volumen oder daneben liegt.</translation>
    </message>
    <message>
        <source>The DICOM object cannot be made; please report it.</source>
        <translation>Das DICOM-Objekt kann nicht erzeugt werden; bitte melden Sie es.</translation>
    </message>
    <message>
        <source>it is no DICOM object, or one that is damaged or cut off</source>
        <translation>sie ist kein DICOM-Objekt, oder ein beschädigtes oder abgeschnittenes</translation>
    </message>
    <message>
        <source>what it says of its patient and study cannot be copied</source>
        <translation>was sie über Patient und Studie sagt, lässt sich nicht übernehmen</translation>
    </message>
    <message>
        <source>It was written by a later Limn, so what only that knows was left aside: update Limn.</source>
        <translation>Sie wurde von einem neueren Limn geschrieben; was nur dieses kennt, blieb unbeachtet: Aktualisieren Sie Limn.</translation>
    </message>
    <message>
        <source>It was changed by another program since Limn wrote it, so its standard attributes alone were read.</source>
        <translation>Sie wurde von einem anderen Programm verändert, seit Limn sie schrieb; gelesen wurden allein ihre Standardattribute.</translation>
    </message>
    <message>
        <source>its images are deformed by a non-linear registration, which Limn cannot draw</source>
        <translation>ihre Bilder werden durch eine nichtlineare Registrierung verformt, was Limn nicht zeichnen kann</translation>
    </message>
    <message>
        <source>its images are moved by a registration, which Limn does not read</source>
        <translation>ihre Bilder werden durch eine Registrierung verschoben, die Limn nicht liest</translation>
    </message>
    <message>
        <source>export a look of the images as they are</source>
        <translation>exportieren Sie eine Darstellung der Bilder, wie sie sind</translation>
    </message>
    <message>
        <source>it has %1 inputs, and Limn draws one volume at a time</source>
        <translation>sie hat %1 Eingaben, und Limn zeichnet ein Volumen zur Zeit</translation>
    </message>
    <message>
        <source>its input is of the kind &quot;%1&quot;, which Limn cannot draw</source>
        <translation>ihre Eingabe ist von der Art „%1“, die Limn nicht zeichnen kann</translation>
    </message>
    <message>
        <source>it does not say which images it belongs to</source>
        <translation>sie sagt nicht, zu welchen Bildern sie gehört</translation>
    </message>
    <message>
        <source>%1 is not within 0 to 1</source>
        <translation>%1 liegt nicht zwischen 0 und 1</translation>
    </message>
    <message>
        <source>The direction of the light is missing; it comes from the viewer.</source>
        <translation>Die Richtung des Lichts fehlt; es kommt vom Betrachter.</translation>
    </message>
    <message>
        <source>the table %1 has %2 entries, where its descriptor announces %3</source>
        <translation>die Tabelle %1 hat %2 Einträge, wo ihre Beschreibung %3 ankündigt</translation>
    </message>
    <message>
        <source>the table %1 is made of segments that refer to others</source>
        <translation>die Tabelle %1 besteht aus Segmenten, die auf andere verweisen</translation>
    </message>
    <message>
        <source>export the look with plain tables</source>
        <translation>exportieren Sie die Darstellung mit einfachen Tabellen</translation>
    </message>
    <message>
        <source>the descriptor %1 does not give the length, first value and bits (8 or 16) of its table</source>
        <translation>die Beschreibung %1 nennt nicht Länge, ersten Wert und Bits (8 oder 16) ihrer Tabelle</translation>
    </message>
    <message>
        <source>it is compressed as a whole, or big endian</source>
        <translation>sie ist als Ganzes komprimiert oder Big Endian</translation>
    </message>
    <message>
        <source>export it as explicit little endian</source>
        <translation>exportieren Sie sie als Explicit Little Endian</translation>
    </message>
    <message>
        <source>it is no look that Limn knows</source>
        <translation>sie ist keine Darstellung, die Limn kennt</translation>
    </message>
    <message>
        <source>The ending of %1 names no kind of look that Limn writes; these do: %2.</source>
        <translation>Die Endung von %1 steht für keine Darstellung, die Limn schreibt; diese tun es: %2.</translation>
    </message>
    <message>
        <source>one of its curves has no points</source>
        <translation>eine ihrer Kurven hat keine Punkte</translation>
    </message>
    <message>
        <source>one of its curves has more than %1 points</source>
        <translation>eine ihrer Kurven hat mehr als %1 Punkte</translation>
    </message>
    <message>
        <source>Opacities or colours outside 0 to 1 were limited to it.</source>
        <translation>Deckkraft oder Farben außerhalb von 0 bis 1 wurden darauf begrenzt.</translation>
    </message>
    <message>
        <source>Opacity and colour end at different values; the shorter curve goes on with its last ones.</source>
        <translation>Deckkraft und Farbe enden bei verschiedenen Werten; die kürzere Kurve setzt sich mit dem fort, was sie zuletzt hat.</translation>
    </message>
    <message>
        <source>The light&apos;s direction was left out: it comes from the viewer there.</source>
        <translation>Die Richtung des Lichts wurde weggelassen: Dort kommt es vom Betrachter.</translation>
    </message>
    <message>
        <source>Surfaces turned away from the light are lit there, too.</source>
        <translation>Dort werden auch Oberflächen beleuchtet, die vom Licht abgewandt sind.</translation>
    </message>
    <message>
        <source>Highlights in the material&apos;s colour became white ones.</source>
        <translation>Glanzlichter in der Farbe des Materials wurden zu weißen.</translation>
    </message>
    <message>
        <source>The exponent %1 of highlights after Blinn-Phong became %2 after Phong, which are as wide.</source>
        <translation>Der Exponent %1 der Glanzlichter nach Blinn-Phong wurde zu %2 nach Phong; sie sind gleich breit.</translation>
    </message>
    <message>
        <source>The exponent %1 of highlights after Phong became %2 after Blinn-Phong, which are as wide.</source>
        <translation>Der Exponent %1 der Glanzlichter nach Phong wurde zu %2 nach Blinn-Phong; sie sind gleich breit.</translation>
    </message>
    <message>
        <source>Numbers of the light were limited to what Limn draws: no coefficient below 0, exponents from %1 to %2.</source>
        <translation>Zahlen des Lichts wurden auf das begrenzt, was Limn zeichnet: kein Koeffizient unter 0, Exponenten von %1 bis %2.</translation>
    </message>
    <message>
        <source>The look says nothing of light; the usual one of such programs was written.</source>
        <translation>Die Darstellung sagt nichts über Licht; geschrieben wurde das übliche solcher Programme.</translation>
    </message>
    <message>
        <source>Gradient opacity was converted between value per voxel and value per mm for voxels of %1 mm.</source>
        <translation>Die Deckkraft nach Gradient wurde zwischen Wert je Voxel und Wert je mm umgerechnet, für Voxel von %1&#xa0;mm.</translation>
    </message>
    <message>
        <source>Gradient opacity was converted between value per voxel and value per mm for voxels of 1 mm; name the volume for which the look is meant (--for) to have its own.</source>
        <translation>Die Deckkraft nach Gradient wurde zwischen Wert je Voxel und Wert je mm umgerechnet, für Voxel von 1&#xa0;mm; nennen Sie das Volumen, für das die Darstellung gedacht ist (--for), damit dessen Voxel gelten.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Its values are relative, from 0 to 1, and stay so; name the volume for which the look is meant (--for) to stretch them over its range.</source>
        <translation>Ihre Werte sind relativ, von 0 bis 1, und bleiben es; nennen Sie das Volumen, für das die Darstellung gedacht ist (--for), um sie über dessen Wertebereich zu strecken.</translation>
    </message>
    <message>
        <source>Its values from 0 to 1 were stretched over %1.</source>
        <translation>Ihre Werte von 0 bis 1 wurden über %1 gestreckt.</translation>
    </message>
    <message>
        <source>Opacities over %1 mm became those over 1 mm, within %2.</source>
        <translation>Deckkraft über %1&#xa0;mm wurde zu solcher über 1&#xa0;mm, auf %2 genau.</translation>
    </message>
    <message>
        <source>The projection &quot;%1&quot; was left out.</source>
        <translation>Die Projektion „%1“ wurde weggelassen.</translation>
    </message>
    <message>
        <source>How the look moves to data of another scale was left out.</source>
        <translation>Wie sich die Darstellung an Daten anderer Skala anpasst, wurde weggelassen.</translation>
    </message>
    <message>
        <source>MITK transfer function</source>
        <translation>Transferfunktion von MITK</translation>
    </message>
    <message>
        <source>it has &quot;%1&quot; where a number is needed</source>
        <translation>sie hat „%1“, wo eine Zahl stehen muss</translation>
    </message>
    <message>
        <source>a colour has another number of parts than four</source>
        <translation>eine Farbe hat nicht vier Teile</translation>
    </message>
    <message>
        <source>it has fewer points than it says</source>
        <translation>sie hat weniger Punkte, als sie nennt</translation>
    </message>
    <message>
        <source>It has more points than the %1 that it counts; those behind them were left out.</source>
        <translation>Sie hat mehr Punkte als die %1, die sie zählt; die dahinter wurden weggelassen.</translation>
    </message>
    <message>
        <source>MRIcroGL colour map</source>
        <translation>Farbtabelle von MRIcroGL</translation>
    </message>
    <message>
        <source>it has something else where a number is needed</source>
        <translation>sie hat etwas anderes, wo eine Zahl stehen muss</translation>
    </message>
    <message>
        <source>its list &quot;%1&quot; is missing</source>
        <translation>ihre Liste „%1“ fehlt</translation>
    </message>
    <message>
        <source>it is no colour map</source>
        <translation>sie ist keine Farbtabelle</translation>
    </message>
    <message>
        <source>it colours labels and not values</source>
        <translation>sie färbt Labels und keine Werte</translation>
    </message>
    <message>
        <source>open a colour map of values instead</source>
        <translation>öffnen Sie stattdessen eine Farbtabelle für Werte</translation>
    </message>
    <message>
        <source>its lists of colours have different lengths</source>
        <translation>ihre Farblisten sind verschieden lang</translation>
    </message>
    <message>
        <source>niivue colour map</source>
        <translation>Farbtabelle von niivue</translation>
    </message>
    <message>
        <source>The numbers of its light &quot;%1&quot; are not in the file; those of &quot;%2&quot; were taken.</source>
        <translation>Die Zahlen ihres Lichts „%1“ stehen nicht in der Datei; die von „%2“ wurden genommen.</translation>
    </message>
    <message>
        <source>a point in it lacks its place</source>
        <translation>einem Punkt darin fehlt seine Stelle</translation>
    </message>
    <message>
        <source>a curve in it has %1 points and %2 colours</source>
        <translation>eine Kurve darin hat %1 Punkte und %2 Farben</translation>
    </message>
    <message>
        <source>it has %1 curves and colours for %2</source>
        <translation>sie hat %1 Kurven und Farben für %2</translation>
    </message>
    <message>
        <source>it has no curves</source>
        <translation>sie hat keine Kurven</translation>
    </message>
    <message>
        <source>it has more than %1 curves</source>
        <translation>sie hat mehr als %1 Kurven</translation>
    </message>
    <message>
        <source>save it with fewer curves</source>
        <translation>speichern Sie sie mit weniger Kurven</translation>
    </message>
    <message>
        <source>Curves that overlap became one; where they do, the most opaque shows.</source>
        <translation>Kurven, die sich überlappen, wurden zu einer; wo sie es tun, ist die deckendste zu sehen.</translation>
    </message>
    <message>
        <source>Its colour table &quot;%1&quot; is another file; greys took its place.</source>
        <translation>Ihre Farbtabelle „%1“ ist eine andere Datei; an ihre Stelle traten Grauwerte.</translation>
    </message>
    <message>
        <source>a channel of its colour table has %1 entries instead of %2</source>
        <translation>ein Kanal ihrer Farbtabelle hat %1 Einträge statt %2</translation>
    </message>
    <message>
        <source>the width of its window is not above 0</source>
        <translation>ihre Fensterbreite liegt nicht über 0</translation>
    </message>
    <message>
        <source>Its opacity table &quot;%1&quot; is not in the file; a linear one took its place.</source>
        <translation>Ihre Deckkrafttabelle „%1“ steht nicht in der Datei; an ihre Stelle trat eine lineare.</translation>
    </message>
    <message>
        <source>Its camera, which is not perspective, was left out: looks hold none.</source>
        <translation>Ihre Kamera, die nicht perspektivisch ist, wurde weggelassen: Darstellungen haben keine.</translation>
    </message>
    <message>
        <source>Its filters of the volume were left out.</source>
        <translation>Ihre Filter des Volumens wurden weggelassen.</translation>
    </message>
    <message>
        <source>Its background was left out: looks hold none.</source>
        <translation>Ihr Hintergrund wurde weggelassen: Darstellungen haben keinen.</translation>
    </message>
    <message>
        <source>it is a property list, but no look of OsiriX, Horos or InVesalius</source>
        <translation>sie ist eine Property List, aber keine Darstellung von OsiriX, Horos oder InVesalius</translation>
    </message>
    <message>
        <source>choose another file</source>
        <translation>wählen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>copy or save it again</source>
        <translation>kopieren oder speichern Sie sie neu</translation>
    </message>
    <message>
        <source>it is a property list without a look</source>
        <translation>sie ist eine Property List ohne Darstellung</translation>
    </message>
    <message>
        <source>Its light became &quot;%1&quot;, the nearest that such files can name.</source>
        <translation>Ihr Licht wurde zu „%1“, dem nächsten, das solche Dateien nennen können.</translation>
    </message>
    <message>
        <source>Its gradient opacity was left out: such files have none.</source>
        <translation>Ihre Deckkraft nach Gradient wurde weggelassen: Solche Dateien haben keine.</translation>
    </message>
    <message>
        <source>must be a list with %1 numbers for each point</source>
        <translation>muss eine Liste mit %1 Zahlen je Punkt sein</translation>
    </message>
    <message>
        <source>Its opacities for ParaView and for VolView differ; those for ParaView were taken.</source>
        <translation>Ihre Deckkraft für ParaView und die für VolView unterscheiden sich; die für ParaView wurde genommen.</translation>
    </message>
    <message>
        <source>It has colours alone; its opacity became a ramp from 0 to 1 over them.</source>
        <translation>Sie hat nur Farben; ihre Deckkraft wurde zu einer Rampe von 0 bis 1 darüber.</translation>
    </message>
    <message>
        <source>Its colour space &quot;%1&quot; became %2.</source>
        <translation>Ihr Farbraum „%1“ wurde zu %2.</translation>
    </message>
    <message>
        <source>Colours between points in the colour space %1 became points in RGB.</source>
        <translation>Farben zwischen Punkten im Farbraum %1 wurden zu Punkten in RGB.</translation>
    </message>
    <message>
        <source>Its logarithmic scale became a linear one with points in between.</source>
        <translation>Ihre logarithmische Skala wurde zu einer linearen mit Punkten dazwischen.</translation>
    </message>
    <message>
        <source>Its colour of values that are no number was left out: Limn has none such.</source>
        <translation>Ihre Farbe für Werte, die keine Zahl sind, wurde weggelassen: Limn hat keine solchen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was passed over: it names colours for single values, which is no curve.</source>
        <translation>„%1“ wurde übergangen: Es nennt Farben für einzelne Werte, was keine Kurve ist.</translation>
    </message>
    <message>
        <source>it holds no colour map</source>
        <translation>sie enthält keine Farbtabelle</translation>
    </message>
    <message>
        <source>its indexed colours belong to single values, which is no curve</source>
        <translation>ihre indizierten Farben gehören zu einzelnen Werten, was keine Kurve ist</translation>
    </message>
    <message>
        <source>choose a colour map over a range of values</source>
        <translation>wählen Sie eine Farbtabelle über einen Wertebereich</translation>
    </message>
    <message>
        <source>Its light was left out: such files hold curves alone.</source>
        <translation>Ihr Licht wurde weggelassen: Solche Dateien haben nur Kurven.</translation>
    </message>
    <message>
        <source>Its gradient opacity was left out: such files hold curves alone.</source>
        <translation>Ihre Deckkraft nach Gradient wurde weggelassen: Solche Dateien haben nur Kurven.</translation>
    </message>
    <message>
        <source>its &quot;%1&quot; is no finite number</source>
        <translation>ihr „%1“ ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>its &quot;%1&quot; is no list</source>
        <translation>ihr „%1“ ist keine Liste</translation>
    </message>
    <message>
        <source>Light and material were left out: the format has no place for them.</source>
        <translation>Licht und Material wurden weggelassen: Das Format hat keinen Platz dafür.</translation>
    </message>
    <message>
        <source>The opacity by gradient was left out: the format has no place for it.</source>
        <translation>Die Deckkraft nach Gradient wurde weggelassen: Das Format hat keinen Platz dafür.</translation>
    </message>
    <message>
        <source>must be a list</source>
        <translation>muss eine Liste sein</translation>
    </message>
    <message>
        <source>Its interpolation &quot;%1&quot; became linear.</source>
        <translation>Ihre Interpolation „%1“ wurde linear.</translation>
    </message>
    <message>
        <source>Of its %1 components only the first was taken.</source>
        <translation>Von ihren %1 Komponenten wurde nur die erste genommen.</translation>
    </message>
    <message>
        <source>Its isosurfaces were left out.</source>
        <translation>Ihre Isoflächen wurden weggelassen.</translation>
    </message>
    <message>
        <source>Its scattering was left out.</source>
        <translation>Ihre Streuung wurde weggelassen.</translation>
    </message>
    <message>
        <source>The value that it gives clipped voxels was left out.</source>
        <translation>Der Wert, den sie abgeschnittenen Voxeln gibt, wurde weggelassen.</translation>
    </message>
    <message>
        <source>The weight of its component was left out.</source>
        <translation>Das Gewicht ihrer Komponente wurde weggelassen.</translation>
    </message>
    <message>
        <source>a volume property in it has no components</source>
        <translation>eine Volumeneigenschaft darin hat keine Komponenten</translation>
    </message>
    <message>
        <source>it holds no volume property</source>
        <translation>sie enthält keine Volumeneigenschaft</translation>
    </message>
    <message>
        <source>The damaged number &quot;%1&quot; was read as %2, as other programs do.</source>
        <translation>Die beschädigte Zahl „%1“ wurde als %2 gelesen, wie es andere Programme tun.</translation>
    </message>
    <message>
        <source>one of its functions should have %1 numbers, %2 for each point, and has %3</source>
        <translation>eine ihrer Funktionen sollte %1 Zahlen haben, %2 je Punkt, und hat %3</translation>
    </message>
    <message>
        <source>Its interpolation, which is not linear, became so.</source>
        <translation>Ihre Interpolation, die nicht linear ist, wurde es.</translation>
    </message>
    <message>
        <source>it has %1 lines instead of %2</source>
        <translation>sie hat %1 Zeilen statt %2</translation>
    </message>
    <message>
        <source>it has no volume property with functions of its own</source>
        <translation>sie hat keine Volumeneigenschaft mit eigenen Funktionen</translation>
    </message>
    <message>
        <source>save the volume property itself from 3D Slicer</source>
        <translation>speichern Sie aus 3D Slicer die Volumeneigenschaft selbst</translation>
    </message>
    <message>
        <source>Its opacity is switched off, so that nothing is seen.</source>
        <translation>Ihre Deckkraft ist ausgeschaltet, sodass nichts zu sehen ist.</translation>
    </message>
    <message>
        <source>It shows all that is seen at all as opaque, which became steps.</source>
        <translation>Sie zeigt alles, was überhaupt zu sehen ist, deckend; daraus wurden Stufen.</translation>
    </message>
    <message>
        <source>its gamma is %1</source>
        <translation>ihr Gamma ist %1</translation>
    </message>
    <message>
        <source>Its gamma of %1 became points, within %2 of the curve.</source>
        <translation>Ihr Gamma von %1 wurde zu Punkten, auf %2 der Kurve genau.</translation>
    </message>
    <message>
        <source>its threshold hides all values</source>
        <translation>ihr Schwellwert verbirgt alle Werte</translation>
    </message>
    <message>
        <source>widen the threshold in Voreen and save it again</source>
        <translation>weiten Sie den Schwellwert in Voreen, und speichern Sie sie neu</translation>
    </message>
    <message>
        <source>Its threshold became points, outside which the opacity is 0.</source>
        <translation>Ihr Schwellwert wurde zu Punkten, außerhalb derer die Deckkraft 0 ist.</translation>
    </message>
    <message>
        <source>Voreen transfer function</source>
        <translation>Transferfunktion von Voreen</translation>
    </message>
    <message>
        <source>Its gradient opacity, which is switched off there, was left out.</source>
        <translation>Ihre Deckkraft nach Gradient, die dort ausgeschaltet ist, wurde weggelassen.</translation>
    </message>
    <message>
        <source>a number of its light is not finite</source>
        <translation>eine Zahl ihres Lichts ist nicht endlich</translation>
    </message>
    <message>
        <source>the length over which its opacities hold is not a positive number</source>
        <translation>die Länge, über die ihre Deckkraft gilt, ist keine positive Zahl</translation>
    </message>
    <message>
        <source>The file does not say over which length its opacities hold; 1 mm was taken.</source>
        <translation>Die Datei sagt nicht, über welche Länge ihre Deckkraft gilt; 1&#xa0;mm wurde angenommen.</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <source>Ambient, diffuse and specular light that differ from point to point became their mean, weighted by opacity: %1, %2 and %3.</source>
        <translation>Umgebungs-, diffuses und spiegelndes Licht, die sich von Punkt zu Punkt unterscheiden, wurden zu ihrem Mittel, nach Deckkraft gewichtet: %1, %2 und %3.</translation>
    </message>
    <message>
        <source>must be a list of groups of points</source>
        <translation>muss eine Liste von Gruppen von Punkten sein</translation>
    </message>
    <message>
        <source>must be a list of points</source>
        <translation>muss eine Liste von Punkten sein</translation>
    </message>
    <message>
        <source>Its points do not ascend in value and were sorted; Weasis would draw some of them otherwise.</source>
        <translation>Ihre Punkte steigen im Wert nicht an und wurden sortiert; Weasis würde einige davon anders zeichnen.</translation>
    </message>
    <message>
        <source>None of its points has a colour; white was taken.</source>
        <translation>Keiner ihrer Punkte hat eine Farbe; Weiß wurde genommen.</translation>
    </message>
    <message>
        <source>it holds no presets</source>
        <translation>sie enthält keine Presets</translation>
    </message>
    <message>
        <source>Its gradient opacity was left out: Weasis has none.</source>
        <translation>Ihre Deckkraft nach Gradient wurde weggelassen: Weasis hat keine.</translation>
    </message>
    <message>
        <source>ParaView, vtk.js or VolView colour map</source>
        <translation>Farbtabelle von ParaView, vtk.js oder VolView</translation>
    </message>
    <message>
        <source>3D Slicer volume property</source>
        <translation>Volumeneigenschaft von 3D Slicer</translation>
    </message>
    <message>
        <source>3D Slicer volume property (older)</source>
        <translation>Volumeneigenschaft von 3D Slicer (älter)</translation>
    </message>
    <message>
        <source>3D Slicer scene or presets (MRML)</source>
        <translation>Szene oder Presets von 3D Slicer (MRML)</translation>
    </message>
    <message>
        <source>Weasis presets</source>
        <translation>Presets von Weasis</translation>
    </message>
    <message>
        <source>OsiriX, Horos or InVesalius 3D preset</source>
        <translation>3D-Preset von OsiriX, Horos oder InVesalius</translation>
    </message>
    <message>
        <source>Values were rounded to whole ones, by up to %1: Weasis has no others.</source>
        <translation>Werte wurden auf ganze gerundet, um bis zu %1: Weasis hat keine anderen.</translation>
    </message>
    <message>
        <source>Its values in percent were taken of the range of values.</source>
        <translation>Ihre Werte in Prozent wurden auf den Wertebereich bezogen.</translation>
    </message>
    <message>
        <source>Its gradient opacity was left out: it follows another measure of the gradient.</source>
        <translation>Ihre Deckkraft nach Gradient wurde weggelassen: Sie folgt einem anderen Maß des Gradienten.</translation>
    </message>
    <message>
        <source>Its colours beyond its ends were left out: the curve goes on with its last ones.</source>
        <translation>Ihre Farben jenseits ihrer Enden wurden weggelassen: Die Kurve setzt sich mit dem fort, was sie zuletzt hat.</translation>
    </message>
    <message>
        <source>Weasis colour maps</source>
        <translation>Farbtabellen von Weasis</translation>
    </message>
    <message>
        <source>its values are fractions of a volume&apos;s range</source>
        <translation>ihre Werte sind Bruchteile des Wertebereichs eines Volumens</translation>
    </message>
    <message>
        <source>open the volume that it is for, then import it again</source>
        <translation>öffnen Sie das Volumen, für das sie gemeint ist, und importieren Sie sie dann erneut</translation>
    </message>
    <message>
        <source>A DICOM look is filed with the series that it is for; name the folder of one (--for FOLDER).</source>
        <translation>Eine Darstellung in DICOM wird bei der Serie abgelegt, für die sie ist; geben Sie den Ordner einer Serie an (--for FOLDER).</translation>
    </message>
    <message>
        <source>Where the opacity is fully sharp it steps, as it was meant; programs on VTK since 2023 draw a ramp there by mistake.</source>
        <translation>Wo die Deckkraft ganz scharf ist, springt sie, wie es gemeint war; Programme mit VTK zeichnen dort seit 2023 irrtümlich eine Rampe.</translation>
    </message>
    <message>
        <source>Taking away triangles</source>
        <translation>Dreiecke werden verringert</translation>
    </message>
    <message>
        <source>Finding the surface</source>
        <translation>Oberfläche wird gesucht</translation>
    </message>
    <message>
        <source>Measuring the surface</source>
        <translation>Oberfläche wird vermessen</translation>
    </message>
    <message>
        <source>Cannot write %1: %2; choose another folder or make room.</source>
        <translation>%1 kann nicht geschrieben werden: %2; wählen Sie einen anderen Ordner oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>The value %1 was given twice; give each once.</source>
        <translation>Der Wert %1 ist doppelt angegeben; geben Sie jeden einmal an.</translation>
    </message>
    <message>
        <source>Writing the surface</source>
        <translation>Oberfläche wird geschrieben</translation>
    </message>
    <message>
        <source>Cannot write %1: its ending names no format of surfaces; use .stl, .ply or .obj.</source>
        <translation>%1 kann nicht geschrieben werden: Die Endung nennt kein Format für Oberflächen; verwenden Sie .stl, .ply oder .obj.</translation>
    </message>
    <message>
        <source>There is no surface at %1, because the volume has values from %2 to %3; choose one between them.</source>
        <translation>Bei %1 gibt es keine Oberfläche, weil das Volumen Werte von %2 bis %3 hat; wählen Sie einen dazwischen.</translation>
    </message>
    <message>
        <source>There is no surface at %1: nothing within the crop and what is kept reaches it; choose a lower value or a larger crop.</source>
        <translation>Bei %1 gibt es keine Oberfläche: Nichts in Zuschnitt und behaltenem Bereich erreicht den Wert; wählen Sie einen kleineren Wert oder einen größeren Zuschnitt.</translation>
    </message>
    <message>
        <source>Counting triangles</source>
        <translation>Dreiecke werden gezählt</translation>
    </message>
    <message>
        <source>Measuring gradients</source>
        <translation>Gradienten werden gemessen</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>DICOM presentation state of a volume</source>
        <translation>DICOM-Präsentationszustand eines Volumens</translation>
    </message>
    <message>
        <source>must be a list of texts</source>
        <translation>muss eine Liste von Texten sein</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>Bilderreihe</translation>
    </message>
    <message>
        <source>The surface would have about %1 million triangles, which need %2 MB of memory where %3 are free; crop the volume, choose another value or open a coarser volume.</source>
        <translation>Die Oberfläche hätte etwa %1&#xa0;Millionen Dreiecke, die %2&#xa0;MB Speicher brauchen, wo %3 frei sind; schneiden Sie das Volumen zu, wählen Sie einen anderen Wert oder öffnen Sie ein gröberes Volumen.</translation>
    </message>
    <message>
        <source>The volume has more rows, or longer ones, than the CPU engine counts: it draws up to %1 rows of %2 voxels; draw a part of it or a reduced copy.</source>
        <translation>Das Volumen hat mehr oder längere Zeilen, als die CPU-Engine zählt: Sie zeichnet bis zu %1 Zeilen aus %2 Voxeln; zeichnen Sie einen Teil davon oder eine verkleinerte Kopie.</translation>
    </message>
    <message>
        <source>The volume of %1 voxels does not lie in memory, from where the graphics driver would copy it.</source>
        <translation>Das Volumen aus %1 Voxeln liegt nicht im Speicher, aus dem der Grafiktreiber es kopieren würde.</translation>
    </message>
    <message>
        <source>Cannot keep the volume&apos;s data in %1: they need %2 GB and %3 GB are free there; make room, or set TMPDIR to a folder on a larger disk.</source>
        <translation>Die Daten des Volumens lassen sich nicht in %1 ablegen: sie brauchen %2&#xa0;GB, und dort sind %3&#xa0;GB frei; Platz schaffen oder TMPDIR auf einen Ordner auf einer größeren Festplatte setzen.</translation>
    </message>
    <message>
        <source>Cannot keep the volume&apos;s data in %1: %2; set TMPDIR to a folder on a disk that can be written.</source>
        <translation>Die Daten des Volumens lassen sich nicht in %1 ablegen: %2; TMPDIR auf einen Ordner auf einer beschreibbaren Festplatte setzen.</translation>
    </message>
    <message>
        <source>Cannot keep the volume&apos;s data on disk: /var/tmp is missing or lies in memory; set TMPDIR to a folder on a disk.</source>
        <translation>Die Daten des Volumens lassen sich nicht auf der Festplatte ablegen: /var/tmp fehlt oder liegt im Speicher; TMPDIR auf einen Ordner auf einer Festplatte setzen.</translation>
    </message>
    <message>
        <source>The voxels are kept on disk while the volume is open (%1 GB in %2), because they need more memory than may be used.</source>
        <translation>Die Voxel liegen auf der Festplatte, solange das Volumen offen ist (%1&#xa0;GB in %2), weil sie mehr Speicher brauchen, als benutzt werden darf.</translation>
    </message>
    <message>
        <source>it became shorter while it was read, or its disk failed</source>
        <translation>sie wurde kürzer, während sie gelesen wurde, oder ihre Festplatte hat versagt</translation>
    </message>
    <message>
        <source>Too many volumes are open; close some of them.</source>
        <translation>Zu viele Volumen sind offen; einige davon schließen.</translation>
    </message>
    <message>
        <source>Cannot read %1: %2; copy the file again.</source>
        <translation>%1 lässt sich nicht lesen: %2; die Datei noch einmal kopieren.</translation>
    </message>
    <message>
        <source>it is too short</source>
        <translation>sie ist zu kurz</translation>
    </message>
    <message>
        <source>The volume&apos;s file became shorter while it was read, or its disk failed; copy the file again and open it anew.</source>
        <translation>Die Datei des Volumens wurde kürzer, während sie gelesen wurde, oder ihre Festplatte hat versagt; die Datei noch einmal kopieren und neu öffnen.</translation>
    </message>
    <message>
        <source>it is no picture, or a damaged one</source>
        <translation>sie ist kein Bild oder ist beschädigt</translation>
    </message>
    <message>
        <source>draw it anew</source>
        <translation>zeichnen Sie das Bild neu</translation>
    </message>
    <message>
        <source>Cannot write %1: there is no folder %2; make it, or choose another folder.</source>
        <translation>%1 kann nicht geschrieben werden: Den Ordner %2 gibt es nicht; legen Sie ihn an, oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>There is no preset &quot;%1&quot;; did you mean &quot;%2&quot;? The command limn presets list names all.</source>
        <translation>Es gibt kein Preset „%1“; meinten Sie „%2“? Der Befehl limn presets list nennt alle.</translation>
    </message>
    <message>
        <source>Cannot write %1: a turntable is a video with the ending .mp4, or frames in a folder, whose name needs no ending.</source>
        <translation>%1 kann nicht geschrieben werden: Eine Drehansicht ist ein Video mit der Endung .mp4 oder besteht aus Einzelbildern in einem Ordner, dessen Name keine Endung braucht.</translation>
    </message>
    <message>
        <source>%1 holds %2 of a longer turntable, which would follow on these %3 frames; choose another folder, or delete it.</source>
        <translation>%1 enthält %2 einer längeren Drehung, das auf diese %3 Bilder folgen würde; wählen Sie einen anderen Ordner oder löschen Sie es.</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>Cannot read %1: there is no such file or folder; did you mean %2?</source>
        <translation>%1 kann nicht gelesen werden: Es gibt keine solche Datei und keinen solchen Ordner; meinten Sie %2?</translation>
    </message>
    <message>
        <source>The graphics card weighs voxels in %1 bits, which alone moves this picture by up to %2: it does not keep the tolerance of %3; ask for the tolerance anew (--tolerance).</source>
        <translation>Die Grafikkarte gewichtet Voxel mit %1&#xa0;Bit, was allein dieses Bild um bis zu %2 verändert: Die Toleranz von %3 wird nicht eingehalten; geben Sie sie neu vor (--tolerance).</translation>
    </message>
    <message>
        <source>estimated within %1, with %2 and own weights between voxels</source>
        <translation>nach Schätzung auf %1 genau, mit %2 und eigenen Gewichten zwischen Voxeln</translation>
    </message>
    <message>
        <source>the graphics card weighs voxels too coarsely for the tolerance</source>
        <translation>die Grafikkarte gewichtet Voxel zu grob für die Toleranz</translation>
    </message>
    <message>
        <source>the weights of the graphics card are fine enough for what is asked</source>
        <translation>die Gewichte der Grafikkarte sind fein genug für das, was verlangt ist</translation>
    </message>
    <message>
        <source>voxels are weighed finely enough without it</source>
        <translation>Voxel werden auch ohne sie fein genug gewichtet</translation>
    </message>
    <message>
        <source>Own weights between voxels</source>
        <translation>Eigene Gewichte zwischen Voxeln</translation>
    </message>
    <message>
        <source>The graphics driver has no room for the looks of labels; draw without them, or with --engine cpu.</source>
        <translation>Der Grafiktreiber hat keinen Platz für die Darstellungen von Labels; zeichnen Sie ohne sie oder mit --engine cpu.</translation>
    </message>
    <message>
        <source>The looks of labels are not kept: one curve is written for all of them.</source>
        <translation>Die Darstellungen von Labels bleiben nicht erhalten: Für alle wird eine Kurve geschrieben.</translation>
    </message>
    <message>
        <source>The scene gives a look to label %1, which %2 does not have; take the look out or choose another label map.</source>
        <translation>Die Szene gibt dem Label %1 eine Darstellung, das %2 nicht hat; nehmen Sie die Darstellung heraus oder wählen Sie eine andere Labelkarte.</translation>
    </message>
    <message>
        <source>no label has a look of its own</source>
        <translation>kein Label hat eine eigene Darstellung</translation>
    </message>
    <message>
        <source>no label that shows has another look than the picture</source>
        <translation>kein sichtbares Label hat eine andere Darstellung als das Bild</translation>
    </message>
    <message>
        <source>this kind of picture takes one value of a ray, not of a label</source>
        <translation>diese Art von Bild nimmt einen Wert eines Strahls, nicht eines Labels</translation>
    </message>
    <message>
        <source>some labels have looks of their own</source>
        <translation>einige Labels haben eigene Darstellungen</translation>
    </message>
    <message>
        <source>Looks of labels</source>
        <translation>Darstellungen von Labels</translation>
    </message>
    <message>
        <source>A look is given to a label that the volume does not have.</source>
        <translation>Eine Darstellung gehört zu einem Label, das das Volumen nicht hat.</translation>
    </message>
    <message>
        <source>The labels have more than %1 different looks, which is as many as can be drawn; give some of them the same look.</source>
        <translation>Die Labels haben mehr als %1 verschiedene Darstellungen, und so viele lassen sich höchstens zeichnen; geben Sie einigen dieselbe Darstellung.</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Cut %1 finds no piece: nothing in its range of values is left at its place.</source>
        <translation>Schnitt %1 findet kein Teil: An seiner Stelle ist nichts in seinem Wertebereich übrig.</translation>
    </message>
    <message>
        <source>Cut %1 takes nothing away: its line goes around nothing that is left.</source>
        <translation>Schnitt %1 nimmt nichts weg: Seine Linie umschließt nichts, was noch übrig ist.</translation>
    </message>
    <message>
        <source>The cuts take everything away.</source>
        <translation>Die Schnitte nehmen alles weg.</translation>
    </message>
    <message>
        <source>What was cut away by hand is shown by other programs.</source>
        <translation>Was von Hand weggeschnitten wurde, zeigen andere Programme.</translation>
    </message>
    <message>
        <source>must be a list of 3 to %1 places [x, y]</source>
        <translation>muss eine Liste von 3 bis %1 Stellen [x, y] sein</translation>
    </message>
    <message>
        <source>must be &quot;all&quot;, &quot;body&quot;, {&quot;labels&quot;: FILE, &quot;weights&quot;: {…}} or a list of these and of cuts</source>
        <translation>muss „all“, „body“, {„labels“: DATEI, „weights“: {…}} oder eine Liste hiervon und von Schnitten sein</translation>
    </message>
    <message>
        <source>The segmentation has %1 labels, which leaves no number for what is cut away; cut without it.</source>
        <translation>Die Segmentierung hat %1 Labels; damit bleibt keine Nummer für das Weggeschnittene. Schneiden Sie ohne sie.</translation>
    </message>
    <message>
        <source>what was cut away is hidden</source>
        <translation>was weggeschnitten wurde, ist ausgeblendet</translation>
    </message>
    <message>
        <source>The measurements were left out: they are of another volume.</source>
        <translation>Die Messungen wurden weggelassen: Sie gehören zu einem anderen Volumen.</translation>
    </message>
    <message>
        <source>The measurements were left out: they are of another series.</source>
        <translation>Die Messungen wurden weggelassen: Sie gehören zu einer anderen Serie.</translation>
    </message>
    <message>
        <source>%1 is no mask and was left out.</source>
        <translation>%1 ist keine Maske und wurde ausgelassen.</translation>
    </message>
    <message>
        <source>%1 files are no masks and were left out: %2.</source>
        <translation>%1 Dateien sind keine Masken und wurden ausgelassen: %2.</translation>
    </message>
    <message>
        <source>%1 voxels lie in more than one mask and belong to the one whose name comes last; most of them, %2, to %3 and not to %4.</source>
        <translation>%1 Voxel liegen in mehr als einer Maske und gehören zu der, deren Name zuletzt kommt; die meisten davon, %2, zu %3 und nicht zu %4.</translation>
    </message>
    <message>
        <source>no file in it is the mask of a structure: 0, and one value inside</source>
        <translation>keine Datei darin ist die Maske einer Struktur: 0, und innen ein Wert</translation>
    </message>
    <message>
        <source>open the folder that the segmentation was written to</source>
        <translation>öffnen Sie den Ordner, in den die Segmentierung geschrieben wurde</translation>
    </message>
    <message>
        <source>all of its masks are empty</source>
        <translation>alle seine Masken sind leer</translation>
    </message>
    <message>
        <source>open the segmentation of this volume</source>
        <translation>öffnen Sie die Segmentierung dieses Volumens</translation>
    </message>
    <message>
        <source>belongs to pieces with &quot;do&quot;: &quot;look&quot; alone</source>
        <translation>gehört nur zu Teilen, deren „do“ „look“ ist</translation>
    </message>
    <message>
        <source>must be a list of as many places as are measured: %1 of %2</source>
        <translation>muss eine Liste mit so vielen Orten sein, wie gemessen werden: %1 von %2</translation>
    </message>
    <message>
        <source>%1 voxels lie in two masks and belong to the one whose name comes last: to %2 and not to %3.</source>
        <translation>%1 Voxel liegen in zwei Masken und gehören zu der, deren Name zuletzt kommt: zu %2 und nicht zu %3.</translation>
    </message>
    <message>
        <source>The picture lies within %1 levels RMS of the exact one, 99.9 % of its colours within %2 (standard error), after %3 paths a pixel.</source>
        <translation>Das Bild liegt im Mittel (RMS) höchstens %1 Stufen neben dem exakten, 99,9&#xa0;% seiner Farben höchstens %2 (Standardfehler), nach %3 Pfaden je Bildpunkt.</translation>
    </message>
    <message>
        <source>The picture has %1 paths a pixel, too few to tell its error.</source>
        <translation>Das Bild hat %1 Pfade je Bildpunkt, zu wenige, um seinen Fehler zu nennen.</translation>
    </message>
    <message>
        <source>Physical light knows no fog: it was left out.</source>
        <translation>Physikalisches Licht kennt keinen Nebel: Er wurde weggelassen.</translation>
    </message>
    <message>
        <source>Physical light knows no surface of one value: tissue is shown as the curve says.</source>
        <translation>Physikalisches Licht kennt keine Fläche eines Wertes: Das Gewebe erscheint, wie die Kurve es sagt.</translation>
    </message>
    <message>
        <source>OpenGL looks shadows and occlusion up on a grid; how far they are off is told with --engine cpu alone.</source>
        <translation>OpenGL schlägt Schatten und Verdeckung in einem Gitter nach; wie weit sie daneben liegen, sagt nur --engine cpu.</translation>
    </message>
    <message>
        <source>With OpenGL no tolerance can be kept where shadows or occlusion show; use --engine cpu or reference, or leave the tolerance out.</source>
        <translation>Mit OpenGL lässt sich keine Toleranz einhalten, wo Schatten oder Verdeckung zu sehen sind; nehmen Sie --engine cpu oder reference, oder lassen Sie die Toleranz weg.</translation>
    </message>
    <message>
        <source>OpenGL cannot draw physical light; use --engine cpu or auto, or another model.</source>
        <translation>OpenGL kann kein physikalisches Licht zeichnen; nehmen Sie --engine cpu oder auto oder ein anderes Modell.</translation>
    </message>
    <message>
        <source>The slices lie %1 mm apart, %2 times as far as the pixels within them: surfaces show a band for each slice, though smooth normals take most of it out of the light.</source>
        <translation>Die Schichten liegen %1&#xa0;mm auseinander, %2-mal so weit wie die Pixel in ihnen: Oberflächen zeigen für jede Schicht ein Band, doch geglättete Normalen nehmen das meiste davon aus dem Licht.</translation>
    </message>
    <message>
        <source>Shadows and occlusion cannot be drawn in bricks: light crosses from one to the next. Draw the picture with limn, or set their strength to 0.</source>
        <translation>Schatten und Verdeckung können nicht in Blöcken gezeichnet werden: Licht geht von einem in den nächsten über. Zeichnen Sie das Bild mit limn, oder setzen Sie ihre Stärke auf 0.</translation>
    </message>
    <message>
        <source>Smooth normals cannot be drawn in bricks: smoothing reaches beyond each of them. Draw the picture with limn, or set the smoothing to 0.</source>
        <translation>Geglättete Normalen können nicht in Blöcken gezeichnet werden: Die Glättung reicht über jeden hinaus. Zeichnen Sie das Bild mit limn, oder setzen Sie die Glättung auf 0.</translation>
    </message>
    <message>
        <source>Physical light cannot be drawn in bricks: its paths cross from one to the next. Draw the picture with limn, or choose another model.</source>
        <translation>Physikalisches Licht lässt sich nicht in Blöcken zeichnen: Seine Pfade gehen von einem in den nächsten. Zeichnen Sie das Bild mit limn oder wählen Sie ein anderes Modell.</translation>
    </message>
    <message>
        <source>The processor alone keeps a tolerance where shadows or occlusion show.</source>
        <translation>Wo Schatten oder Verdeckung zu sehen sind, hält nur der Prozessor eine Toleranz ein.</translation>
    </message>
    <message>
        <source>Physical light is drawn by the processor, not with OpenGL.</source>
        <translation>Physikalisches Licht zeichnet der Prozessor, nicht OpenGL.</translation>
    </message>
    <message>
        <source>The graphics driver has no room for shadows and occlusion; draw without them, or with --engine cpu.</source>
        <translation>Der Grafiktreiber hat keinen Platz für Schatten und Verdeckung; zeichnen Sie ohne sie oder mit --engine cpu.</translation>
    </message>
    <message>
        <source>The graphics card has no room for a smoothed copy of the volume beside it; set the smoothing of normals to 0, or draw with --engine cpu.</source>
        <translation>Die Grafikkarte hat neben dem Volumen keinen Platz für eine geglättete Kopie; setzen Sie die Glättung der Normalen auf 0, oder zeichnen Sie mit --engine cpu.</translation>
    </message>
    <message>
        <source>Physical light is not kept: the model is written as classic.</source>
        <translation>Physikalisches Licht bleibt nicht erhalten: Das Modell wird als klassisch geschrieben.</translation>
    </message>
    <message>
        <source>The light no longer turns with the camera: it stays where it is now.</source>
        <translation>Das Licht dreht sich nicht mehr mit der Kamera: Es bleibt, wo es jetzt ist.</translation>
    </message>
    <message>
        <source>Shadows are not kept.</source>
        <translation>Schatten bleiben nicht erhalten.</translation>
    </message>
    <message>
        <source>Occlusion is not kept: ambient light reaches everything alike.</source>
        <translation>Die Verdeckung bleibt nicht erhalten: Umgebungslicht erreicht alles gleich.</translation>
    </message>
    <message>
        <source>Smooth normals are not kept: terraces of thick slices show in the light.</source>
        <translation>Geglättete Normalen bleiben nicht erhalten: Absätze dicker Schichten zeigen sich im Licht.</translation>
    </message>
    <message>
        <source>Shadows were left out.</source>
        <translation>Schatten wurden weggelassen.</translation>
    </message>
    <message>
        <source>Occlusion was left out: ambient light reaches everything alike there.</source>
        <translation>Die Verdeckung wurde weggelassen: Umgebungslicht erreicht dort alles gleich.</translation>
    </message>
    <message>
        <source>The smoothing of normals was left out.</source>
        <translation>Die Glättung der Normalen wurde weggelassen.</translation>
    </message>
    <message>
        <source>must be &quot;headlight&quot;, or a direction that is not zero, in world axes or as {&quot;camera&quot;: [right, up, forward]}</source>
        <translation>muss „headlight“ sein oder eine Richtung, die nicht null ist, in Weltachsen oder als {camera: [rechts, oben, vorn]}</translation>
    </message>
    <message>
        <source>must be the only end: {&quot;paths&quot;: n}, {&quot;levels&quot;: x} or {&quot;seconds&quot;: s}</source>
        <translation>muss das einzige Ende sein: {paths: n}, {levels: x} oder {seconds: s}</translation>
    </message>
    <message>
        <source>must be smaller than the upper ends on every axis</source>
        <translation>muss auf jeder Achse kleiner sein als die oberen Enden</translation>
    </message>
    <message>
        <source>The reference follows no random paths and cannot draw physical light; use --engine cpu or another model.</source>
        <translation>Die Referenz folgt keinen Zufallspfaden und kann kein physikalisches Licht zeichnen; nehmen Sie --engine cpu oder ein anderes Modell.</translation>
    </message>
    <message>
        <source>physical light stands in its place</source>
        <translation>an seiner Stelle steht physikalisches Licht</translation>
    </message>
    <message>
        <source>the light comes from a direction of its own and turns with the viewer</source>
        <translation>das Licht kommt aus einer eigenen Richtung und dreht sich mit dem Betrachter</translation>
    </message>
    <message>
        <source>what stands between tissue and the light casts a shadow</source>
        <translation>was zwischen Gewebe und Licht steht, wirft einen Schatten</translation>
    </message>
    <message>
        <source>the strength of shadows is set to 0</source>
        <translation>die Stärke der Schatten steht auf 0</translation>
    </message>
    <message>
        <source>a light that comes from the viewer casts no shadow</source>
        <translation>ein Licht, das vom Betrachter kommt, wirft keinen Schatten</translation>
    </message>
    <message>
        <source>less ambient light reaches hollows and what lies close together</source>
        <translation>in Vertiefungen und zwischen eng Benachbartem kommt weniger Umgebungslicht an</translation>
    </message>
    <message>
        <source>the strength of occlusion is set to 0</source>
        <translation>die Stärke der Verdeckung steht auf 0</translation>
    </message>
    <message>
        <source>there is no ambient light</source>
        <translation>es gibt kein Umgebungslicht</translation>
    </message>
    <message>
        <source>light goes random ways through tissue, which scatters and absorbs it</source>
        <translation>Licht geht Zufallswege durch das Gewebe, das es streut und schluckt</translation>
    </message>
    <message>
        <source>this kind of picture shows values without light</source>
        <translation>diese Art Bild zeigt Werte ohne Licht</translation>
    </message>
    <message>
        <source>the physical model is not chosen</source>
        <translation>das physikalische Modell ist nicht gewählt</translation>
    </message>
    <message>
        <source>terraces of thick slices are taken out of the light</source>
        <translation>Absätze dicker Schichten werden aus dem Licht genommen</translation>
    </message>
    <message>
        <source>the smoothing is set to 0 mm</source>
        <translation>die Glättung steht auf 0&#xa0;mm</translation>
    </message>
    <message>
        <source>the smoothing is finer than the voxels</source>
        <translation>die Glättung ist feiner als die Voxel</translation>
    </message>
    <message>
        <source>physical light knows tissue, its key light and its sky alone</source>
        <translation>physikalisches Licht kennt nur Gewebe, sein Hauptlicht und seinen Himmel</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Dark hollows (occlusion)</source>
        <translation>Dunkle Vertiefungen (Verdeckung)</translation>
    </message>
    <message>
        <source>Smooth normals</source>
        <translation>Geglättete Normalen</translation>
    </message>
    <message>
        <source>Physical light</source>
        <translation>Physikalisches Licht</translation>
    </message>
    <message>
        <source>The segmentation has %1 labels, which leaves no number for what is not the body; switch Body only off.</source>
        <translation>Die Segmentierung hat %1 Labels, sodass für das, was nicht Körper ist, keine Nummer bleibt; schalten Sie „Nur Körper“ aus.</translation>
    </message>
    <message>
        <source>Slices cannot draw physical light; use --engine cpu or another model.</source>
        <translation>Schichten können kein physikalisches Licht zeichnen; nehmen Sie --engine cpu oder ein anderes Modell.</translation>
    </message>
    <message>
        <source>Slices cannot draw shadows and occlusion; use --engine gl, cpu or reference, or set their strength to 0.</source>
        <translation>Schichten können Schatten und Verdeckung nicht zeichnen; nehmen Sie --engine gl, cpu oder reference, oder setzen Sie ihre Stärke auf 0.</translation>
    </message>
    <message>
        <source>Following %1 paths a pixel</source>
        <translation>Verfolge %1 Pfade je Bildpunkt</translation>
    </message>
    <message>
        <source>A picture of physical light of %1 × %2 pixels keeps %3 GB of what its paths find, and %4 GB of memory are free; choose a smaller one or close other programs.</source>
        <translation>Ein Bild in physikalischem Licht von %1 × %2 Bildpunkten hält %3 GB von dem, was seine Pfade finden, und %4 GB Speicher sind frei; wählen Sie ein kleineres oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>From %1 to %2 paths a pixel the error (RMS) falls as their number to the power of −%3; the law of chance is −0.5. A quarter of it, %4 instead of %5 levels, takes 16 times as many paths and as long: %6 paths, %7 s.</source>
        <translation>Von %1 bis %2 Pfaden je Bildpunkt fällt der Fehler (RMS) mit ihrer Zahl hoch −%3; das Gesetz des Zufalls ist −0,5. Ein Viertel davon, %4 statt %5 Stufen, braucht 16-mal so viele Pfade und so lange: %6 Pfade, %7&#xa0;s.</translation>
    </message>
    <message>
        <source>The volume is compressed or text, which can only be read from its start: every process reads all of it and keeps its part.</source>
        <translation>Das Volumen ist komprimiert oder Text und kann nur von Anfang an gelesen werden: Jeder Prozess liest alles und behält seinen Teil.</translation>
    </message>
    <message>
        <source>The slices are straightened, for which every process reads and keeps all of them.</source>
        <translation>Die Schichten werden begradigt; dafür liest und behält jeder Prozess alle.</translation>
    </message>
    <message>
        <source>changes nothing in this picture that could be seen</source>
        <translation>ändert in diesem Bild nichts, was man sehen könnte</translation>
    </message>
    <message>
        <source>changes this picture by up to %1 of 255 levels, by %2 on average</source>
        <translation>ändert dieses Bild um bis zu %1 von 255 Stufen, im Mittel um %2</translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of %1 × %2 pixels; choose a smaller one.</source>
        <translation>Der Speicher reicht nicht für ein Bild von %1 × %2 Pixeln; wählen Sie ein kleineres.</translation>
    </message>
    <message>
        <source>save the file again in the program that made it</source>
        <translation>speichern Sie die Datei in ihrem Programm neu</translation>
    </message>
    <message>
        <source>save the file again in the program that made it, or correct that in a text editor</source>
        <translation>speichern Sie die Datei in ihrem Programm neu, oder berichtigen Sie das in einem Texteditor</translation>
    </message>
    <message>
        <source>it does not hold what such a file holds</source>
        <translation>sie enthält nicht, was eine solche Datei enthält</translation>
    </message>
    <message>
        <source>its &quot;%1&quot; does not hold what it should: names and their values in braces</source>
        <translation>ihr Eintrag „%1“ enthält nicht, was er soll: Namen und ihre Werte in geschweiften Klammern</translation>
    </message>
    <message>
        <source>its &quot;%1&quot; %2</source>
        <translation>ihr Eintrag „%1“ %2</translation>
    </message>
    <message>
        <source>is %1 and must be %2</source>
        <translation>ist %1 und muss %2 sein</translation>
    </message>
    <message>
        <source>is &quot;%1&quot; and must be one of %2</source>
        <translation>ist „%1“ und muss eines von diesen sein: %2</translation>
    </message>
    <message>
        <source>is nothing that Limn knows there</source>
        <translation>ist nichts, was Limn dort kennt</translation>
    </message>
    <message>
        <source>it is no %1 of Limn</source>
        <translation>sie ist von Limn keine Datei der Art „%1“</translation>
    </message>
    <message>
        <source>it is a %1 of a newer Limn</source>
        <translation>sie stammt von einem neueren Limn (%1)</translation>
    </message>
    <message>
        <source>open it with that one</source>
        <translation>öffnen Sie sie mit diesem</translation>
    </message>
    <message>
        <source>it is a property list that is not text</source>
        <translation>sie ist eine Property List, die kein Text ist</translation>
    </message>
    <message>
        <source>make it text first, on a Mac with: plutil -convert xml1 FILE</source>
        <translation>machen Sie sie erst zu Text, auf einem Mac mit: plutil -convert xml1 DATEI</translation>
    </message>
    <message>
        <source>it is damaged or cut off</source>
        <translation>sie ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>its &quot;%1&quot; of &quot;%2&quot; is &quot;%3&quot; and no number</source>
        <translation>ihr „%1“ von „%2“ ist „%3“ und keine Zahl</translation>
    </message>
    <message>
        <source>its &quot;%1&quot; lacks &quot;%2&quot;</source>
        <translation>ihrem „%1“ fehlt „%2“</translation>
    </message>
    <message>
        <source>must be a list of names with cameras</source>
        <translation>muss eine Liste von Namen mit Kameras sein</translation>
    </message>
    <message>
        <source>is missing, which names the file of the label map</source>
        <translation>fehlt, der die Datei der Labelkarte nennt</translation>
    </message>
    <message>
        <source>is missing: a look is a list of control points</source>
        <translation>fehlt: eine Darstellung ist eine Liste von Kontrollpunkten</translation>
    </message>
    <message>
        <source>is missing, under which the line was drawn</source>
        <translation>fehlt, die Kamera, unter der die Linie gezeichnet wurde</translation>
    </message>
    <message>
        <source>is missing, which is a place of the piece</source>
        <translation>fehlt, der eine Stelle des Teils ist</translation>
    </message>
    <message>
        <source>is missing, which has the lowest and the highest value of the piece</source>
        <translation>fehlt, der den niedrigsten und den höchsten Wert des Teils hat</translation>
    </message>
    <message>
        <source>is missing, which is the piece&apos;s own list of control points</source>
        <translation>fehlt, der die eigene Liste von Kontrollpunkten des Teils ist</translation>
    </message>
    <message>
        <source>is missing, and so are piece and labels, of which an entry has one</source>
        <translation>fehlt, ebenso piece und labels, von denen ein Eintrag eines hat</translation>
    </message>
    <message>
        <source>names the body or a segmentation twice, and each can stand there once</source>
        <translation>nennt den Körper oder eine Segmentierung zweimal, und jedes kann dort einmal stehen</translation>
    </message>
    <message>
        <source>has an entry that is neither a part nor &quot;all&quot; or &quot;body&quot;</source>
        <translation>hat einen Eintrag, der weder ein Teil ist noch „all“ oder „body“</translation>
    </message>
    <message>
        <source>must be a list of points with gradient and opacity</source>
        <translation>muss eine Liste von Punkten mit Gradient und Deckkraft sein</translation>
    </message>
    <message>
        <source>is missing, which names the file or folder of the volume</source>
        <translation>fehlt, der Datei oder Ordner des Volumens nennt</translation>
    </message>
    <message>
        <source>Smooth normals of this volume take %1 GB of memory, and %2 GB are free; switch them off, or close other programs.</source>
        <translation>Geglättete Normalen dieses Volumens brauchen %1&#xa0;GB Speicher, und %2&#xa0;GB sind frei; schalten Sie sie aus, oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>it is no report of limn accuracy</source>
        <translation>sie ist kein Bericht von limn accuracy</translation>
    </message>
    <message>
        <source>curves of labels may change faster than one step can follow; where looks of labels meet, samples stand for steps</source>
        <translation>Kurven von Labels ändern sich vielleicht schneller, als ein Schritt folgen kann; wo Darstellungen von Labels aneinandergrenzen, stehen Abtastpunkte für Schritte</translation>
    </message>
    <message>
        <source>Cut %1 takes nothing away: its line goes around all that is left.</source>
        <translation>Schnitt %1 nimmt nichts weg: Seine Linie umschließt alles, was noch übrig ist.</translation>
    </message>
    <message>
        <source>The picture has %1 paths a pixel, too few to filter their noise.</source>
        <translation>Das Bild hat %1 Pfade je Bildpunkt, zu wenige, um ihr Rauschen zu filtern.</translation>
    </message>
    <message>
        <source>The noise of %1 paths a pixel was filtered, which changed colours by %2 levels RMS, by %3 at most; they are too few to tell what error is left.</source>
        <translation>Das Rauschen von %1 Pfaden je Bildpunkt wurde gefiltert, was Farben um %2 Stufen RMS geändert hat, höchstens um %3; für eine Aussage über den verbleibenden Fehler sind es zu wenige.</translation>
    </message>
    <message>
        <source>The picture lies within about %1 levels RMS of the exact one, after %2 paths a pixel whose noise was filtered: that changed colours by %3 levels RMS, by %4 at most, and was judged by paths that the filter did not see.</source>
        <translation>Das Bild liegt bis auf etwa %1 Stufen RMS beim exakten, nach %2 Pfaden je Bildpunkt, deren Rauschen gefiltert wurde: Das hat Farben um %3 Stufen RMS geändert, höchstens um %4, und wurde an Pfaden gemessen, die der Filter nicht kannte.</translation>
    </message>
    <message>
        <source>The saved view looks past this volume: the look was taken over, and the view is fitted to this volume.</source>
        <translation>Die gespeicherte Ansicht blickt an diesem Volumen vorbei: Die Darstellung wurde übernommen, und die Ansicht ist diesem Volumen angepasst.</translation>
    </message>
    <message>
        <source>%1 voxels lie in two masks and belong to the one that was opened last: to %2 and not to %3.</source>
        <translation>%1 Voxel liegen in zwei Masken und gehören zu der zuletzt geöffneten: zu %2 und nicht zu %3.</translation>
    </message>
    <message>
        <source>%1 voxels lie in more than one mask and belong to the one that was opened last; most of them, %2, to %3 and not to %4.</source>
        <translation>%1 Voxel liegen in mehr als einer Maske und gehören zu der zuletzt geöffneten; die meisten davon, %2, zu %3 und nicht zu %4.</translation>
    </message>
    <message>
        <source>neither it nor another file that was chosen is the mask of a structure: 0, and one value inside</source>
        <translation>weder sie noch eine andere gewählte Datei ist die Maske einer Struktur: 0 und innen ein Wert</translation>
    </message>
    <message>
        <source>open a file of several labels by itself</source>
        <translation>öffnen Sie eine Datei mit mehreren Labels für sich allein</translation>
    </message>
    <message>
        <source>it and the other masks that were chosen are empty</source>
        <translation>sie und die anderen gewählten Masken sind leer</translation>
    </message>
    <message>
        <source>Curve, projection and light were taken over; its view, quality and background were not.</source>
        <translation>Kurve, Projektion und Licht wurden übernommen; Ansicht, Qualität und Hintergrund nicht.</translation>
    </message>
    <message>
        <source>Its fog was left out.</source>
        <translation>Der Nebel wurde weggelassen.</translation>
    </message>
    <message>
        <source>What was cropped, cut or hidden there was left out.</source>
        <translation>Was dort beschnitten, weggeschnitten oder ausgeblendet war, wurde weggelassen.</translation>
    </message>
    <message>
        <source>Its measurements were left out.</source>
        <translation>Die Messungen wurden weggelassen.</translation>
    </message>
    <message>
        <source>it leaves the curve to its volume</source>
        <translation>sie überlässt die Kurve ihrem Volumen</translation>
    </message>
    <message>
        <source>open it and export the look that is shown</source>
        <translation>öffnen Sie sie und exportieren Sie die gezeigte Darstellung</translation>
    </message>
    <message>
        <source>the figure shows slices alone</source>
        <translation>die Abbildung zeigt nur Schichten</translation>
    </message>
    <message>
        <source>choose a figure with a picture</source>
        <translation>wählen Sie eine Abbildung mit einem Bild</translation>
    </message>
    <message>
        <source>picture, figure, scene or session of Limn</source>
        <translation>Bild, Abbildung, Szene oder Sitzung von Limn</translation>
    </message>
    <message>
        <source>choose a preset or picture of Limn, or a look that 3D Slicer, OsiriX, Horos, InVesalius, ParaView, Weasis, MITK, Inviwo, Voreen, MRIcroGL, NiiVue or ImageVis3D saved</source>
        <translation>wählen Sie ein Preset oder ein Bild von Limn oder eine Darstellung, die 3D Slicer, OsiriX, Horos, InVesalius, ParaView, Weasis, MITK, Inviwo, Voreen, MRIcroGL, NiiVue oder ImageVis3D gespeichert hat</translation>
    </message>
    <message>
        <source>must name a file, or be a list of the files of masks</source>
        <translation>muss eine Datei nennen oder eine Liste der Dateien von Masken sein</translation>
    </message>
    <message>
        <source>The curves that single labels and pieces had were left out.</source>
        <translation>Die eigenen Kurven einzelner Labels und Stücke wurden weggelassen.</translation>
    </message>
    <message>
        <source>Its names of single values were left out: Limn&apos;s curves have none.</source>
        <translation>Seine Namen einzelner Werte wurden weggelassen: Kurven von Limn haben keine.</translation>
    </message>
    <message>
        <source>saves %1 of %2 ms</source>
        <translation>spart %1 von %2&#xa0;ms</translation>
    </message>
    <message>
        <source>the folder %1 takes no files</source>
        <translation>der Ordner %1 nimmt keine Dateien auf</translation>
    </message>
    <message>
        <source>%1 voxels that %2 had before belong to no mask now; open a mask that has them, too, once more.</source>
        <translation>%1 Voxel, die vorher zu %2 gehörten, gehören jetzt zu keiner Maske; öffnen Sie eine Maske, die sie auch enthält, noch einmal.</translation>
    </message>
    <message>
        <source>The shading model %1 was left out, with its exponent range, opacity range and gradient reference: other programs light by the classic model or not at all.</source>
        <translation>Das Schattierungsmodell %1 wurde weggelassen, mit seinem Exponentenbereich, Deckkraftbereich und Gradientenbezug: Andere Programme beleuchten nach dem klassischen Modell oder gar nicht.</translation>
    </message>
    <message>
        <source>Physical light was left out: other programs light by the classic model or not at all.</source>
        <translation>Das physikalische Licht wurde weggelassen: Andere Programme beleuchten nach dem klassischen Modell oder gar nicht.</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>Vorgang nicht erlaubt</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein- oder Ausgabefehler</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Keine Berechtigung</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>Datei gibt es schon</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>Kein Ordner</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Ist ein Ordner</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Der Datenträger lässt sich nur lesen</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Dateiname zu lang</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Zugeteilter Speicherplatz aufgebraucht</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1&#xa0;±&#xa0;%2</translation>
    </message>
    <message>
        <source>would take hardly any time</source>
        <translation>würde kaum Zeit kosten</translation>
    </message>
    <message>
        <source>would save %1 of %2 ms</source>
        <translation>würde %1 von %2&#xa0;ms sparen</translation>
    </message>
    <message>
        <source>would take %1 ms more</source>
        <translation>würde %1&#xa0;ms mehr kosten</translation>
    </message>
    <message>
        <source>would change nothing in this picture that could be seen</source>
        <translation>würde in diesem Bild nichts Sichtbares ändern</translation>
    </message>
    <message>
        <source>would change this picture by up to %1 of 255 levels, by %2 on average</source>
        <translation>würde dieses Bild um bis zu %1 von 255 Stufen ändern, im Mittel um %2</translation>
    </message>
    <message>
        <source>The session&apos;s volume %1 is not where the session expects it (%2); say where it is (--volume PATH).</source>
        <translation>Das Volumen %1 der Sitzung ist nicht dort, wo die Sitzung es erwartet (%2); geben Sie an, wo es ist (--volume PATH).</translation>
    </message>
    <message>
        <source>The volume %1 of this picture is not where the picture expects it (%2); say where it is (--volume PATH).</source>
        <translation>Das Volumen %1 dieses Bildes ist nicht dort, wo das Bild es erwartet (%2); geben Sie an, wo es ist (--volume PATH).</translation>
    </message>
    <message>
        <source>The labels were left out: they are of another volume.</source>
        <translation>Die Labels wurden weggelassen: Sie gehören zu einem anderen Volumen.</translation>
    </message>
    <message>
        <source>The labels were left out, as you asked; the file keeps them.</source>
        <translation>Die Labels wurden weggelassen, wie gewünscht; die Datei behält sie.</translation>
    </message>
    <message>
        <source>This may be another volume than the session&apos;s: its file has another name.</source>
        <translation>Dies ist vielleicht ein anderes Volumen als das der Sitzung: Seine Datei heißt anders.</translation>
    </message>
    <message>
        <source>This is another volume than the session&apos;s: %1 × %2 × %3 voxels in place of %4 × %5 × %6.</source>
        <translation>Dies ist ein anderes Volumen als das der Sitzung: %1 × %2 × %3 Voxel statt %4 × %5 × %6.</translation>
    </message>
    <message>
        <source>The session&apos;s values may mean other tissue here: not both volumes are in Hounsfield units.</source>
        <translation>Die Werte der Sitzung bedeuten hier vielleicht anderes Gewebe: Nicht beide Volumen sind in Hounsfield-Einheiten.</translation>
    </message>
    <message>
        <source>equal steps of %1 voxel</source>
        <translation>gleichen Schritten von %1 Voxel</translation>
    </message>
    <message>
        <source>%1 voxel lies in two masks and belongs to the one whose name comes last: to %2 and not to %3.</source>
        <translation>%1 Voxel liegt in zwei Masken und gehört zu der, deren Name zuletzt kommt: zu %2 und nicht zu %3.</translation>
    </message>
    <message>
        <source>%1 voxel lies in two masks and belongs to the one that was opened last: to %2 and not to %3.</source>
        <translation>%1 Voxel liegt in zwei Masken und gehört zu der zuletzt geöffneten: zu %2 und nicht zu %3.</translation>
    </message>
    <message>
        <source>%1 voxel that %2 had before belongs to no mask now; open a mask that has it, too, once more.</source>
        <translation>%1 Voxel, das vorher zu %2 gehörte, gehört jetzt zu keiner Maske; öffnen Sie eine Maske, die es auch hat, noch einmal.</translation>
    </message>
    <message>
        <source>estimated within %1, with steps and paths of light of fineness %2</source>
        <translation>nach Schätzung auf %1 genau, mit Schritten und Lichtpfaden der Feinheit %2</translation>
    </message>
    <message>
        <source>Single pixels lie farther off than the tolerance of %1, which is kept by an estimate; ask for less, such as --tolerance %2, for a picture that keeps it in these, too.</source>
        <translation>Einzelne Pixel liegen weiter ab als die Toleranz von %1, die nach Schätzung eingehalten ist; verlangen Sie weniger, etwa --tolerance %2, damit auch diese sie einhalten.</translation>
    </message>
    <message>
        <source>Shadows and occlusion come along few paths of light, which is estimated to move the picture by up to %1; --tolerance has as many followed as it needs.</source>
        <translation>Schatten und Verdeckung kommen von wenigen Lichtpfaden, was das Bild nach Schätzung um bis zu %1 verschiebt; mit --tolerance wird so vielen gefolgt, wie nötig sind.</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>es gibt keine solche Datei</translation>
    </message>
    <message>
        <source>choose a PNG, TIFF, JPEG or EXR picture</source>
        <translation>wählen Sie ein Bild als PNG, TIFF, JPEG oder EXR</translation>
    </message>
    <message>
        <source>%1 has no voxels of its own: %2, read after it, covers them.</source>
        <translation>%1 hat keine eigenen Voxel: %2, danach gelesen, bedeckt sie.</translation>
    </message>
    <message>
        <source>%1 has no voxels of its own: masks read after it cover them.</source>
        <translation>%1 hat keine eigenen Voxel: Danach gelesene Masken bedecken sie.</translation>
    </message>
    <message>
        <source>%1 labels have no voxels of their own, because %2, read after them, covers them: %3.</source>
        <translation>%1 Labels haben keine eigenen Voxel, weil %2, danach gelesen, sie bedeckt: %3.</translation>
    </message>
    <message>
        <source>%1 labels have no voxels of their own, because masks read after them cover them: %2.</source>
        <translation>%1 Labels haben keine eigenen Voxel, weil danach gelesene Masken sie bedecken: %2.</translation>
    </message>
    <message>
        <source>The slices slant by %1°, as of a tilted gantry, and were resampled upright.</source>
        <translation>Die Schichten liegen um %1° schräg, wie bei gekippter Gantry, und wurden auf ein aufrechtes Gitter umgerechnet.</translation>
    </message>
    <message>
        <source>The corners that the upright grid adds beside its slices hold no data.</source>
        <translation>Die Ecken, die das aufrechte Gitter neben seinen Schichten ergänzt, enthalten keine Daten.</translation>
    </message>
    <message>
        <source>The figure has %1 panels, of which the window shows the first.</source>
        <translation>Die Abbildung hat %1 Teilbilder, von denen das Fenster das erste zeigt.</translation>
    </message>
    <message>
        <source>The figure has %1 panels, of which the window shows %2.</source>
        <translation>Die Abbildung hat %1 Teilbilder, von denen das Fenster %2 zeigt.</translation>
    </message>
    <message>
        <source>The command limn figure draws all of them again.</source>
        <translation>Der Befehl limn figure zeichnet alle erneut.</translation>
    </message>
    <message>
        <source>it is a text, not a volume</source>
        <translation>sie ist ein Text, kein Volumen</translation>
    </message>
</context>
<context>
    <name>limn::MessageBar</name>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>What can be done about it</source>
        <translation>Was sich tun lässt</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Shows every remark about this volume.</source>
        <translation>Zeigt alle Hinweise zu diesem Volumen.</translation>
    </message>
    <message>
        <source>Hides this message.</source>
        <translation>Blendet diese Meldung aus.</translation>
    </message>
</context>
<context>
    <name>limn::MessagePanel</name>
    <message>
        <source>The picture cannot be drawn</source>
        <translation>Das Bild kann nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
</context>
<context>
    <name>limn::ModelSection</name>
    <message>
        <source>Highlight sharpness (SP)</source>
        <translation>Glanzlichtschärfe (SP)</translation>
    </message>
    <message>
        <source>Small numbers give broad, soft highlights; large ones small, hard points of light.</source>
        <translation>Kleine Zahlen ergeben breite, weiche Glanzlichter, große ergeben kleine, harte Lichtpunkte.</translation>
    </message>
    <message>
        <source>Highlights go from the first sharpness on flat tissue to the second at strong boundaries, so that edges glint and flat parts stay calm.</source>
        <translation>Glanzlichter gehen von der ersten Schärfe in homogenem Gewebe zur zweiten an starken Grenzflächen, sodass Kanten glänzen und Flächen ruhig bleiben.</translation>
    </message>
    <message>
        <source>on flat tissue</source>
        <translation>in homogenem Gewebe</translation>
    </message>
    <message>
        <source>at boundaries</source>
        <translation>an Grenzflächen</translation>
    </message>
    <message>
        <source>Boundary emphasis (O)</source>
        <translation>Grenzflächen­betonung (O)</translation>
    </message>
    <message>
        <source>Multiplies opacity: by the first number on flat tissue, which below 1 fades, and by the second at strong boundaries, which above 1 stand out.</source>
        <translation>Multipliziert die Deckkraft: mit der ersten Zahl in homogenem Gewebe, das unter 1 verblasst, und mit der zweiten an starken Grenzflächen, die über 1 hervortreten.</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Model, left</source>
        <translation>Modell, links</translation>
    </message>
    <message>
        <source>Model, right</source>
        <translation>Modell, rechts</translation>
    </message>
    <message>
        <source>Enhanced and robust</source>
        <translation>„Verstärkt“ und „Robust“</translation>
    </message>
    <message>
        <source>Only the classic model has one sharpness everywhere, and it is not shown.</source>
        <translation>Nur das klassische Modell hat überall dieselbe Schärfe, und es wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>Only the enhanced and robust models follow boundaries, and none is shown.</source>
        <translation>Nur die Modelle „Verstärkt“ und „Robust“ folgen Grenzflächen, und keines wird gezeigt.</translation>
    </message>
    <message>
        <source>How tissue is lit: not at all, evenly, with boundaries emphasised, or the same without overflowing highlights; or by light that goes random ways through it.</source>
        <translation>Wie Gewebe beleuchtet wird: gar nicht, gleichmäßig, mit betonten Grenzen oder ebenso ohne überlaufende Glanzlichter; oder durch Licht, das Zufallswege hindurch geht.</translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation>Wie in der Publikation</translation>
    </message>
    <message>
        <source>enhanced as in the paper</source>
        <translation>Verstärkt wie in der Publikation</translation>
    </message>
    <message>
        <source>The numbers are those of the paper.</source>
        <translation>Die Zahlen sind die der Publikation.</translation>
    </message>
    <message>
        <source>Sharpness, emphasis and boundaries by the paper&apos;s formulas alone: presets have numbers that show their own tissue better.</source>
        <translation>Schärfe, Betonung und Grenzen allein nach den Formeln der Publikation: Presets haben Zahlen, die ihr Gewebe besser zeigen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; at the left stays as it is; curve and light shape the right side, and Preset ▸ Swap the sides exchanges both.</source>
        <translation>„%1“ links bleibt, wie es ist; Kurve und Licht formen die rechte Seite, und Preset ▸ Seiten tauschen vertauscht beide.</translation>
    </message>
    <message>
        <source>Enhanced, robust and physical</source>
        <translation>„Verstärkt“, „Robust“ und „Physikalisch“</translation>
    </message>
    <message>
        <source>Only the enhanced, robust and physical models have such highlights, and none is shown.</source>
        <translation>Nur die Modelle „Verstärkt“, „Robust“ und „Physikalisch“ haben solche Glanzlichter, und keines wird gezeigt.</translation>
    </message>
    <message>
        <source>Physical light has highlights on surfaces with gloss alone, and there are none.</source>
        <translation>Physikalisches Licht hat Glanzlichter nur auf glänzenden Oberflächen, und es gibt keine.</translation>
    </message>
</context>
<context>
    <name>limn::NameDialog</name>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>limn::NumberField</name>
    <message>
        <source>%1 does not fit: give a number from %2 to %3, or per cent such as 10 %.</source>
        <translation>%1 passt nicht: Geben Sie eine Zahl von %2 bis %3 ein, oder Prozent wie 10&#xa0;%.</translation>
    </message>
    <message>
        <source>%1 does not fit: give a number from %2 to %3.</source>
        <translation>%1 passt nicht: Geben Sie eine Zahl von %2 bis %3 ein.</translation>
    </message>
    <message>
        <source>%1 does not fit: give a number from %2 to %3, or from %4 to %5.</source>
        <translation>%1 passt nicht: Geben Sie eine Zahl von %2 bis %3 oder von %4 bis %5 ein.</translation>
    </message>
</context>
<context>
    <name>limn::OpeningController</name>
    <message>
        <source>The scene&apos;s volume is not where the scene expects it: %1.</source>
        <translation>Das Volumen der Szene ist nicht dort, wo die Szene es erwartet: %1.</translation>
    </message>
    <message>
        <source>Locate volume…</source>
        <translation>Volumen suchen…</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Opening the volume</source>
        <translation>Volumen wird geöffnet</translation>
    </message>
    <message>
        <source>Restoring the session</source>
        <translation>Sitzung wird wiederhergestellt</translation>
    </message>
    <message>
        <source>Where is the volume of %1?</source>
        <translation>Wo ist das Volumen von %1?</translation>
    </message>
    <message>
        <source>Open a volume, session, scene or Limn picture</source>
        <translation>Volumen, Sitzung, Szene oder Limn-Bild öffnen</translation>
    </message>
    <message>
        <source>Open a DICOM folder or an image stack</source>
        <translation>DICOM-Ordner oder Bilderstapel öffnen</translation>
    </message>
    <message>
        <source>Voxel spacing</source>
        <translation>Voxelabstand</translation>
    </message>
    <message>
        <source>Distance between voxel centres along x, y and z in millimetres:</source>
        <translation>Abstand der Voxelmitten entlang x, y und z in Millimetern:</translation>
    </message>
    <message>
        <source>The spacing must be three positive numbers, such as 0.5, 0.5, 1.2.</source>
        <translation>Der Voxelabstand muss aus drei positiven Zahlen bestehen, etwa 0,5; 0,5; 1,2.</translation>
    </message>
    <message>
        <source>%1, opened %2</source>
        <translation>%1, geöffnet %2</translation>
    </message>
    <message>
        <source>Everything Limn reads (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vti *.vtk *.dcm *.inv3 *.hdr *.tif *.tiff *.png *.jpg *.json *.exr *.pdf *.vp *.plist *.itf *.clut *.tfi *.1dt)</source>
        <translation>Alles, was Limn liest (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vti *.vtk *.dcm *.inv3 *.hdr *.tif *.tiff *.png *.jpg *.json *.exr *.pdf *.vp *.plist *.itf *.clut *.tfi *.1dt)</translation>
    </message>
    <message>
        <source>The series that this look belongs to is not beside it.</source>
        <translation>Die Serie, zu der diese Darstellung gehört, liegt nicht daneben.</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Zuletzt &amp;geöffnet</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>Datei ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Opens a volume, a session, a scene or a picture that Limn saved.</source>
        <translation>Öffnet ein Volumen, eine Sitzung, eine Szene oder ein von Limn gespeichertes Bild.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open &amp;DICOM folder…</source>
        <translation>&amp;DICOM-Ordner öffnen…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>Open the sample &amp;head</source>
        <translation>Bei&amp;spielkopf öffnen</translation>
    </message>
    <message>
        <source>Clear recent files</source>
        <translation>Liste letzter Dateien leeren</translation>
    </message>
    <message>
        <source>Empties the list of recent files, and with it where volumes lie and dialogs open.</source>
        <translation>Leert die Liste zuletzt geöffneter Dateien und damit auch, wo Volumen liegen und Dialoge beginnen.</translation>
    </message>
    <message>
        <source>The session&apos;s volume is not where the session expects it: %1.</source>
        <translation>Das Volumen der Sitzung ist nicht dort, wo die Sitzung es erwartet: %1.</translation>
    </message>
    <message>
        <source>The volume of this picture is not where the picture expects it: %1.</source>
        <translation>Das Volumen dieses Bildes ist nicht dort, wo das Bild es erwartet: %1.</translation>
    </message>
    <message>
        <source>Locate labels…</source>
        <translation>Labels suchen…</translation>
    </message>
    <message>
        <source>Open without labels</source>
        <translation>Ohne Labels öffnen</translation>
    </message>
    <message>
        <source>Where are the labels %1?</source>
        <translation>Wo sind die Labels %1?</translation>
    </message>
    <message>
        <source>%1 is not where it was: it was moved or deleted, or its drive or network folder is not connected.</source>
        <translation>%1 ist nicht mehr dort: verschoben oder gelöscht, oder das Laufwerk oder der Netzwerkordner ist nicht verbunden.</translation>
    </message>
    <message>
        <source>Remove from recent files</source>
        <translation>Aus den zuletzt geöffneten entfernen</translation>
    </message>
</context>
<context>
    <name>limn::OrientationController</name>
    <message>
        <source>From the last column</source>
        <translation>Von der letzten Spalte</translation>
    </message>
    <message>
        <source>From the first column</source>
        <translation>Von der ersten Spalte</translation>
    </message>
    <message>
        <source>From the last row</source>
        <translation>Von der letzten Zeile</translation>
    </message>
    <message>
        <source>From the first row</source>
        <translation>Von der ersten Zeile</translation>
    </message>
    <message>
        <source>From the last slice</source>
        <translation>Von der letzten Schicht</translation>
    </message>
    <message>
        <source>From the first slice</source>
        <translation>Von der ersten Schicht</translation>
    </message>
    <message>
        <source>set orientation %1</source>
        <translation>Orientierung %1 festlegen</translation>
    </message>
    <message>
        <source>take back the orientation</source>
        <translation>Orientierung zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>&amp;Blick von</translation>
    </message>
    <message>
        <source>Reset camera</source>
        <translation>Kamera zurücksetzen</translation>
    </message>
    <message>
        <source>Set &amp;orientation…</source>
        <translation>&amp;Orientierung festlegen…</translation>
    </message>
    <message>
        <source>Says which side is left where the volume&apos;s file does not.</source>
        <translation>Legt fest, welche Seite links ist, wo die Datei des Volumens es nicht angibt.</translation>
    </message>
    <message>
        <source>Look from</source>
        <translation>Blick von</translation>
    </message>
    <message>
        <source>Anterior (front)</source>
        <translation>Anterior (vorn)</translation>
    </message>
    <message>
        <source>Posterior (back)</source>
        <translation>Posterior (hinten)</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Superior (above)</source>
        <translation>Superior (oben)</translation>
    </message>
    <message>
        <source>Inferior (below)</source>
        <translation>Inferior (unten)</translation>
    </message>
    <message>
        <source>Show orientation &amp;cube</source>
        <translation>Orientierungs&amp;würfel zeigen</translation>
    </message>
    <message>
        <source>A cube in the picture shows how it lies; a click on a face looks from there.</source>
        <translation>Ein Würfel im Bild zeigt, wie es liegt; ein Klick auf eine Fläche blickt von dort.</translation>
    </message>
</context>
<context>
    <name>limn::OrientationDialog</name>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Füße</translation>
    </message>
    <message>
        <source>Orientation of the volume</source>
        <translation>Orientierung des Volumens</translation>
    </message>
    <message>
        <source>The file does not say how its voxels lie in the patient. Say where each axis runs to; the picture follows. A wrong answer swaps left and right: compare with something known.</source>
        <translation>Die Datei gibt nicht an, wie ihre Voxel im Patienten liegen. Geben Sie an, wohin jede Achse läuft; das Bild folgt. Eine falsche Antwort vertauscht links und rechts: Vergleichen Sie mit etwas Bekanntem.</translation>
    </message>
    <message>
        <source>Columns run to</source>
        <translation>Spalten laufen nach</translation>
    </message>
    <message>
        <source>Rows run to</source>
        <translation>Zeilen laufen nach</translation>
    </message>
    <message>
        <source>Slices run to</source>
        <translation>Schichten laufen nach</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Flip: %1</source>
        <translation>Umkehren: %1</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>limn::OwnPresetController</name>
    <message>
        <source>&amp;Save as preset…</source>
        <translation>Als Preset s&amp;peichern…</translation>
    </message>
    <message>
        <source>My preset</source>
        <translation>Mein Preset</translation>
    </message>
    <message>
        <source>My %1</source>
        <translation>%1 (eigenes)</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Als Preset speichern</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a built-in preset; choose another name.</source>
        <translation>„%1“ ist ein mitgeliefertes Preset; wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>A preset needs a name.</source>
        <translation>Ein Preset braucht einen Namen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was replaced by what is shown.</source>
        <translation>„%1“ wurde durch das Gezeigte ersetzt.</translation>
    </message>
    <message>
        <source>Take the old one back</source>
        <translation>Das alte zurückholen</translation>
    </message>
    <message>
        <source>Replace preset</source>
        <translation>Preset ersetzen</translation>
    </message>
    <message>
        <source>There is a preset &quot;%1&quot; already. Replace it by what is shown?</source>
        <translation>Es gibt schon ein Preset „%1“. Durch das ersetzen, was zu sehen ist?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was deleted.</source>
        <translation>„%1“ wurde gelöscht.</translation>
    </message>
    <message>
        <source>Bring it back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>There is a preset &quot;%1&quot; already; choose another name.</source>
        <translation>Ein Preset „%1“ gibt es schon; wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Rename preset</source>
        <translation>Preset umbenennen</translation>
    </message>
    <message>
        <source>New name:</source>
        <translation>Neuer Name:</translation>
    </message>
    <message>
        <source>Note of &quot;%1&quot;</source>
        <translation>Notiz zu „%1“</translation>
    </message>
    <message>
        <source>What it shows, in one sentence:</source>
        <translation>Was es zeigt, in einem Satz:</translation>
    </message>
    <message>
        <source>New folder</source>
        <translation>Neuer Ordner</translation>
    </message>
    <message>
        <source>Folder for &quot;%1&quot;:</source>
        <translation>Ordner für „%1“:</translation>
    </message>
    <message>
        <source>Duplicate preset</source>
        <translation>Preset duplizieren</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 Kopie</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is as it was before.</source>
        <translation>„%1“ ist wieder wie vorher.</translation>
    </message>
    <message>
        <source>Name of the copy:</source>
        <translation>Name der Kopie:</translation>
    </message>
    <message>
        <source>There is a preset &quot;%1&quot; already. Replace it by the copy?</source>
        <translation>Es gibt schon ein Preset „%1“. Durch die Kopie ersetzen?</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was replaced by a copy.</source>
        <translation>„%1“ wurde durch eine Kopie ersetzt.</translation>
    </message>
</context>
<context>
    <name>limn::PanelCycle</name>
    <message>
        <source>&amp;Next panel</source>
        <translation>&amp;Nächster Bereich</translation>
    </message>
    <message>
        <source>&amp;Previous panel</source>
        <translation>&amp;Vorheriger Bereich</translation>
    </message>
    <message>
        <source>&amp;Keyboard focus</source>
        <translation>Bereic&amp;h wechseln</translation>
    </message>
</context>
<context>
    <name>limn::PanelList</name>
    <message>
        <source>&amp;Panels</source>
        <translation>Teilbil&amp;der</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Teilbilder</translation>
    </message>
    <message>
        <source>4, in two rows</source>
        <translation>4, in zwei Reihen</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>%1, side by side</source>
        <translation>%1, nebeneinander</translation>
    </message>
    <message>
        <source>What panel %1 shows</source>
        <translation>Was Teilbild %1 zeigt</translation>
    </message>
    <message>
        <source>Name above panel %1</source>
        <translation>Name über Teilbild %1</translation>
    </message>
    <message>
        <source>no name</source>
        <translation>kein Name</translation>
    </message>
</context>
<context>
    <name>limn::Panels</name>
    <message>
        <source>Prop&amp;erties</source>
        <translation>Eigens&amp;chaften</translation>
    </message>
    <message>
        <source>Effec&amp;ts</source>
        <translation>&amp;Effekte</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Ausgangszustand</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>Verlau&amp;f</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
</context>
<context>
    <name>limn::PhysicalSection</name>
    <message>
        <source>Paths a pixel</source>
        <translation>Pfade je Bildpunkt</translation>
    </message>
    <message>
        <source>Four times as many paths halve the noise, and take four times as long.</source>
        <translation>Viermal so viele Pfade halbieren das Rauschen und brauchen viermal so lange.</translation>
    </message>
    <message>
        <source>Noise left</source>
        <translation>Restrauschen</translation>
    </message>
    <message>
        <source>The standard error that may be left, RMS over the picture, in 255 levels of brightness; half of it takes four times as long.</source>
        <translation>Der Standardfehler, der bleiben darf, RMS über das Bild, in 255 Helligkeitsstufen; die Hälfte braucht viermal so lange.</translation>
    </message>
    <message>
        <source>levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Time for it</source>
        <translation>Zeit dafür</translation>
    </message>
    <message>
        <source>How long a picture may take.</source>
        <translation>Wie lange ein Bild dauern darf.</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Physical light</source>
        <translation>Physikalisches Licht</translation>
    </message>
    <message>
        <source>unused: not in this model</source>
        <translation>nicht in diesem Modell</translation>
    </message>
    <message>
        <source>Tissue scatters</source>
        <translation>Gewebe streut</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>How dense everything is beside what the curve says: thinner lets light deeper in, denser keeps it at the surface.</source>
        <translation>Wie dicht alles ist, neben dem, was die Kurve sagt: Dünner lässt Licht tiefer hinein, dichter hält es an der Oberfläche.</translation>
    </message>
    <message>
        <source>Forward scatter (g)</source>
        <translation>Vorwärtsstreuung (g)</translation>
    </message>
    <message>
        <source>Where light goes that hits something inside tissue: above 0 rather on, below 0 rather back, at 0 all ways alike. Real tissue lies near 0.9.</source>
        <translation>Wohin Licht geht, das im Gewebe auf etwas trifft: über 0 eher weiter, unter 0 eher zurück, bei 0 in alle Richtungen gleich. Echtes Gewebe liegt nahe 0,9.</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Oberflächen</translation>
    </message>
    <message>
        <source>How much of the light that meets a clear boundary comes back from it as from a surface, instead of going on in all directions.</source>
        <translation>Wie viel des Lichts, das auf eine deutliche Grenze trifft, wie von einer Oberfläche zurückkommt, statt in alle Richtungen weiterzugehen.</translation>
    </message>
    <message>
        <source>Gloss</source>
        <translation>Glanz</translation>
    </message>
    <message>
        <source>How much of that is a highlight; the rest comes back matt, in the tissue&apos;s colour.</source>
        <translation>Wie viel davon Glanzlicht ist; der Rest kommt matt zurück, in der Farbe des Gewebes.</translation>
    </message>
    <message>
        <source>Lamp and sky</source>
        <translation>Lampe und Himmel</translation>
    </message>
    <message>
        <source>Lamp strength</source>
        <translation>Stärke der Lampe</translation>
    </message>
    <message>
        <source>At 1 a white surface that faces the lamp shows as white.</source>
        <translation>Bei 1 erscheint eine weiße Fläche, die der Lampe zugewandt ist, weiß.</translation>
    </message>
    <message>
        <source>Lamp size</source>
        <translation>Größe der Lampe</translation>
    </message>
    <message>
        <source>How large the lamp is, as the angle from its middle to its rim: 0° casts hard shadows, 45° hardly any edge.</source>
        <translation>Wie groß die Lampe ist, als Winkel von der Mitte zum Rand: 0° wirft harte Schatten, 45° kaum eine Kante.</translation>
    </message>
    <message>
        <source>Sky above</source>
        <translation>Himmel oben</translation>
    </message>
    <message>
        <source>The light that comes from all around, here from straight above; 1 is as bright as white paper under the lamp.</source>
        <translation>Das Licht, das von ringsum kommt, hier von ganz oben; 1 ist so hell wie weißes Papier unter der Lampe.</translation>
    </message>
    <message>
        <source>Sky below</source>
        <translation>Himmel unten</translation>
    </message>
    <message>
        <source>The same from straight below; between both it changes evenly.</source>
        <translation>Dasselbe von ganz unten; dazwischen ändert es sich gleichmäßig.</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Brightens or darkens the whole picture, as a camera does: each step of 1 doubles its light. No path is followed anew.</source>
        <translation>Hellt das ganze Bild auf oder dunkelt es ab, wie eine Kamera: Jeder Schritt um 1 verdoppelt sein Licht. Kein Pfad wird neu verfolgt.</translation>
    </message>
    <message>
        <source>Saved pictures</source>
        <translation>Gespeicherte Bilder</translation>
    </message>
    <message>
        <source>Drawn until</source>
        <translation>Gezeichnet, bis</translation>
    </message>
    <message>
        <source>When a picture that is saved, filed or put into a figure has enough paths; the window goes on while nothing moves.</source>
        <translation>Wann ein Bild, das gespeichert, abgelegt oder in eine Abbildung gestellt wird, genug Pfade hat; das Fenster geht weiter, solange sich nichts bewegt.</translation>
    </message>
    <message>
        <source>A number of paths</source>
        <translation>eine Zahl von Pfaden</translation>
    </message>
    <message>
        <source>Little noise is left</source>
        <translation>wenig Rauschen bleibt</translation>
    </message>
    <message>
        <source>Its time is up</source>
        <translation>die Zeit um ist</translation>
    </message>
    <message>
        <source>Only physical light has this, and no picture is drawn in it.</source>
        <translation>Das hat nur physikalisches Licht, und kein Bild wird darin gezeichnet.</translation>
    </message>
    <message>
        <source>Filter the noise that is left</source>
        <translation>Übriges Rauschen filtern</translation>
    </message>
    <message>
        <source>Means over pixels that show the same take the grain away, and a little of the finest detail with it. What that changed, and what error is left, is said with the picture. The window shows pictures without it.</source>
        <translation>Mittelwerte über Bildpunkte, die dasselbe zeigen, nehmen das Korn weg und ein wenig der feinsten Einzelheiten mit. Was das geändert hat und welcher Fehler bleibt, wird zum Bild gesagt. Das Fenster zeigt Bilder ohne Filter.</translation>
    </message>
    <message>
        <source>noise filter on</source>
        <translation>Rauschfilter an</translation>
    </message>
    <message>
        <source>noise filter off</source>
        <translation>Rauschfilter aus</translation>
    </message>
    <message>
        <source>Noise that may be left</source>
        <translation>Rauschen, das bleiben darf</translation>
    </message>
    <message>
        <source>Time for a picture</source>
        <translation>Zeit für ein Bild</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Stufe</translation>
    </message>
</context>
<context>
    <name>limn::PictureArea</name>
    <message>
        <source>Left dra&amp;g</source>
        <translation>&amp;Werkzeug der linken Taste</translation>
    </message>
    <message>
        <source>Left drag: %1 (%2)</source>
        <translation>Ziehen mit links: %1 (%2)</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>[ or Esc</source>
        <translation>[ oder Esc</translation>
    </message>
    <message>
        <source>rotate the picture</source>
        <translation>Bild drehen</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>move the picture</source>
        <translation>Bild verschieben</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>up is nearer</source>
        <translation>nach oben kommt das Bild näher</translation>
    </message>
    <message>
        <source>Window/level</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>right widens the window, up raises its level</source>
        <translation>nach rechts wird das Fenster breiter, nach oben seine Lage höher</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>The picture is still being drawn; copy it in a moment.</source>
        <translation>Das Bild wird noch gezeichnet; kopieren Sie es in einem Augenblick.</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>draw around what shall be cut away</source>
        <translation>umfahren, was weggeschnitten werden soll</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>a click picks what hangs together, a drag rotates</source>
        <translation>ein Klick wählt, was zusammenhängt; Ziehen dreht</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>a click marks a place, a drag rotates</source>
        <translation>ein Klick markiert einen Ort, Ziehen dreht</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>drawn in a slice; a drag rotates</source>
        <translation>wird in einer Schicht gezeichnet; Ziehen dreht</translation>
    </message>
    <message>
        <source>clicks set both ends, or a drag over tissue does; beside it a drag rotates</source>
        <translation>Klicks setzen beide Enden, oder Ziehen über Gewebe; daneben dreht Ziehen</translation>
    </message>
    <message>
        <source>clicks set an end, the corner and the other end; a drag over tissue draws the first leg</source>
        <translation>Klicks setzen ein Ende, den Scheitel und das andere Ende; Ziehen über Gewebe zeichnet den ersten Schenkel</translation>
    </message>
</context>
<context>
    <name>limn::PictureDialog</name>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>As on screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Twice as large</source>
        <translation>Doppelt so groß</translation>
    </message>
    <message>
        <source>Four times as large</source>
        <translation>Viermal so groß</translation>
    </message>
    <message>
        <source>For print, 300 dpi</source>
        <translation>Für den Druck, 300 dpi</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>Width on paper</source>
        <translation>Breite auf Papier</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>What stands behind the tissue. JPEG knows no transparent ground.</source>
        <translation>Was hinter dem Gewebe steht. JPEG kennt keinen durchsichtigen Hintergrund.</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>Br&amp;eite</translation>
    </message>
    <message>
        <source>&amp;Ground</source>
        <translation>&amp;Hintergrund</translation>
    </message>
    <message>
        <source>With it</source>
        <translation>Dazu</translation>
    </message>
    <message>
        <source>&amp;Letters of the sides (R, L, …)</source>
        <translation>&amp;Buchstaben der Seiten (R, L, …)</translation>
    </message>
    <message>
        <source>&quot;Not for &amp;diagnosis&quot;</source>
        <translation>„Nicht zur &amp;Diagnose“</translation>
    </message>
    <message>
        <source>&amp;Measurements</source>
        <translation>&amp;Messungen</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message>
        <source>%1 × %2 pixels: more than %3 a side cannot be drawn</source>
        <translation>%1 × %2 Pixel: Mehr als %3 je Seite können nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>Save the slice</source>
        <translation>Schicht speichern</translation>
    </message>
    <message>
        <source>&amp;Names: plane, place, window</source>
        <translation>&amp;Namen: Ebene, Lage, Fensterung</translation>
    </message>
    <message>
        <source>%1 has the ground of the screen: JPEG knows no transparent one. Save the picture as PNG to have none.</source>
        <translation>%1 hat den Hintergrund des Bildschirms: JPEG kennt keinen durchsichtigen. Speichern Sie das Bild als PNG, um keinen zu haben.</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Ändern …</translation>
    </message>
    <message>
        <source>How far pictures of physical light that are saved are drawn; it is set in Properties.</source>
        <translation>Wie weit gespeicherte Bilder physikalischen Lichts gezeichnet werden; eingestellt wird es bei den Eigenschaften.</translation>
    </message>
    <message>
        <source>Physical light</source>
        <translation>Physikalisches Licht</translation>
    </message>
    <message>
        <source>%1, %2 to draw</source>
        <comment>pixels, a time</comment>
        <translation>%1, zu zeichnen in %2</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>Breite in Pixeln</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Scale &amp;bar</source>
        <translation>Maßs&amp;tab</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern…</translation>
    </message>
    <message>
        <source>%1, the time to draw is being estimated</source>
        <comment>pixels</comment>
        <translation>%1, die Dauer des Zeichnens wird geschätzt</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>H&amp;öhe</translation>
    </message>
    <message>
        <source>Size in pixels</source>
        <translation>Größe in Pixeln</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>Höhe in Pixeln</translation>
    </message>
    <message>
        <source>From %1 to %2 pixels.</source>
        <translation>Von %1 bis %2 Pixel.</translation>
    </message>
    <message>
        <source>Shape of the &amp;view</source>
        <translation>&amp;Form der Ansicht</translation>
    </message>
    <message>
        <source>Locked: the height follows from the width. Unlocked: the picture shows as much from top to bottom as on screen, and at the sides what fits.</source>
        <translation>Gesperrt: Die Höhe folgt aus der Breite. Offen: Das Bild zeigt von oben bis unten so viel wie der Bildschirm und an den Seiten, was hineinpasst.</translation>
    </message>
    <message>
        <source>Model &amp;names, and what is hidden</source>
        <translation>&amp;Namen der Modelle, und was ausgeblendet ist</translation>
    </message>
</context>
<context>
    <name>limn::PictureMenu</name>
    <message>
        <source>Turn about this</source>
        <translation>Um diese Stelle drehen</translation>
    </message>
    <message>
        <source>Turns go about what is seen here until the camera is reset (R). Shift+middle click does the same.</source>
        <translation>Gedreht wird um das, was hier zu sehen ist, bis die Kamera zurückgesetzt wird (R). Umschalt+Mittelklick tut dasselbe.</translation>
    </message>
    <message>
        <source>Turn about the middle</source>
        <translation>Um die Mitte drehen</translation>
    </message>
    <message>
        <source>Turns go about the middle of the view again.</source>
        <translation>Gedreht wird wieder um die Bildmitte.</translation>
    </message>
    <message>
        <source>Turns go about the middle of the view already.</source>
        <translation>Gedreht wird bereits um die Bildmitte.</translation>
    </message>
    <message>
        <source>Copy value: %1</source>
        <translation>Wert kopieren: %1</translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation>Wert kopieren</translation>
    </message>
    <message>
        <source>Puts the value that is seen here on the clipboard, with its unit.</source>
        <translation>Legt den Wert, der hier zu sehen ist, mit seiner Einheit in die Zwischenablage.</translation>
    </message>
    <message>
        <source>Go there in slices</source>
        <translation>In den Schnitten dorthin gehen</translation>
    </message>
    <message>
        <source>There are no slices beside the picture; View ▸ Slices shows them.</source>
        <translation>Neben dem Bild stehen keine Schnitte; Ansicht ▸ Schnitte zeigt sie.</translation>
    </message>
    <message>
        <source>Moves the crosshair to what is seen here. Shift+click does the same.</source>
        <translation>Setzt das Fadenkreuz auf das, was hier zu sehen ist. Umschalt+Klick tut dasselbe.</translation>
    </message>
    <message>
        <source>Look from</source>
        <translation>Blick von</translation>
    </message>
    <message>
        <source>Pick this piece</source>
        <translation>Dieses Teil wählen</translation>
    </message>
    <message>
        <source>Lights up what hangs together here, to be hidden or kept alone.</source>
        <translation>Hebt hervor, was hier zusammenhängt, um es auszublenden oder allein zu behalten.</translation>
    </message>
    <message>
        <source>Take %1 in hand</source>
        <translation>%1 auswählen</translation>
    </message>
    <message>
        <source>Take this label in hand</source>
        <translation>Dieses Label auswählen</translation>
    </message>
    <message>
        <source>No segmentation is open; File ▸ Open labels… opens one.</source>
        <translation>Keine Segmentierung ist offen; Datei ▸ Labels öffnen… öffnet eine.</translation>
    </message>
    <message>
        <source>Selects it in the list of labels, and shows its curve.</source>
        <translation>Wählt es in der Liste der Labels aus und zeigt seine Kurve.</translation>
    </message>
    <message>
        <source>Selects it in the list of labels.</source>
        <translation>Wählt es in der Liste der Labels aus.</translation>
    </message>
    <message>
        <source>Copy this slice</source>
        <translation>Diese Schicht kopieren</translation>
    </message>
    <message>
        <source>Puts the slice on the clipboard as it is seen, with sides, scale and measurements, without the crosshair.</source>
        <translation>Legt die Schicht in die Zwischenablage, wie sie zu sehen ist: mit Seiten, Maßstab und Messungen, ohne Fadenkreuz.</translation>
    </message>
    <message>
        <source>Save this slice…</source>
        <translation>Diese Schicht speichern …</translation>
    </message>
    <message>
        <source>Saves the same as a picture, as large as you like.</source>
        <translation>Speichert dasselbe als Bild, so groß Sie wollen.</translation>
    </message>
</context>
<context>
    <name>limn::PictureSaving</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel: saving the picture</source>
        <translation>Abbrechen: Bild wird gespeichert</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.jpg *.exr)</source>
        <translation>Bilder (*.png *.tif *.jpg *.exr)</translation>
    </message>
    <message>
        <source>Saving %1 once the picture is complete</source>
        <translation>%1 wird gespeichert, sobald das Bild fertig ist</translation>
    </message>
    <message>
        <source>The picture changed before it was complete, so it is not saved; save it again.</source>
        <translation>Das Bild hat sich geändert, bevor es fertig war, und wurde nicht gespeichert; speichern Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation>&amp;Bild speichern…</translation>
    </message>
    <message>
        <source>Saves the picture on screen at full quality, with its scene inside.</source>
        <translation>Speichert das gezeigte Bild in voller Qualität, mit seiner Szene darin.</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Another picture is being drawn into its file; wait until it is there, or cancel it in the status bar.</source>
        <translation>Ein anderes Bild wird gerade in seine Datei gezeichnet; warten Sie, bis es da ist, oder brechen Sie es in der Statuszeile ab.</translation>
    </message>
    <message>
        <source>Cancelled; nothing was saved.</source>
        <translation>Abgebrochen; nichts wurde gespeichert.</translation>
    </message>
    <message>
        <source>The 3D picture is saved without the slices: a right click on a slice saves that one, and File ▸ Save figure puts both in one file.</source>
        <translation>Das 3D-Bild wird ohne die Schichten gespeichert: Ein Rechtsklick auf eine Schicht speichert diese, und Datei ▸ Abbildung speichern fasst beides in einer Datei zusammen.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Ctrl+Shift+P</translation>
    </message>
    <message>
        <source>Saving %1 once it is known how exact the picture is</source>
        <translation>%1 wird gespeichert, sobald bekannt ist, wie genau das Bild ist</translation>
    </message>
    <message>
        <source>Saving %1 once the picture is refined</source>
        <translation>%1 wird gespeichert, sobald das Bild verfeinert ist</translation>
    </message>
    <message>
        <source>Saving %1 once the picture is refined: %2 %</source>
        <translation>%1 wird gespeichert, sobald das Bild verfeinert ist: %2&#xa0;%</translation>
    </message>
</context>
<context>
    <name>limn::PictureStatus</name>
    <message>
        <source>Accuracy of the picture</source>
        <translation>Genauigkeit des Bildes</translation>
    </message>
    <message>
        <source>Accuracy: %1</source>
        <translation>Genauigkeit: %1</translation>
    </message>
    <message>
        <source>Press for levels and steps.</source>
        <translation>Für Stufen und Schrittweite drücken.</translation>
    </message>
</context>
<context>
    <name>limn::PlaneBar</name>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>Crosshair (C)</source>
        <translation>Fadenkreuz (C)</translation>
    </message>
    <message>
        <source>Window/level (W)</source>
        <translation>Fensterung (W)</translation>
    </message>
    <message>
        <source>Distance (D)</source>
        <translation>Abstand (D)</translation>
    </message>
    <message>
        <source>Left drag: the place that all slices and the mark in the picture show.</source>
        <translation>Ziehen mit links: die Stelle, die alle Schnitte und die Marke im Bild zeigen.</translation>
    </message>
    <message>
        <source>Left drag: right widens the window, up raises its level. The right button always does.</source>
        <translation>Ziehen mit links: nach rechts wird das Fenster breiter, nach oben seine Lage höher. Die rechte Taste tut das immer.</translation>
    </message>
    <message>
        <source>Left drag: measures from one end to the other; Delete takes it away.</source>
        <translation>Ziehen mit links: misst von einem Ende zum anderen; Entf löscht den Abstand.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Grey windows to choose from.</source>
        <translation>Fensterungen zur Auswahl.</translation>
    </message>
    <message>
        <source>Window width</source>
        <translation>Fensterbreite</translation>
    </message>
    <message>
        <source>How many values lie between black and white.</source>
        <translation>Wie viele Werte zwischen Schwarz und Weiß liegen.</translation>
    </message>
    <message>
        <source>Window level</source>
        <translation>Fensterlage</translation>
    </message>
    <message>
        <source>The value in the middle between black and white.</source>
        <translation>Der Wert in der Mitte zwischen Schwarz und Weiß.</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Slab thickness in mm</source>
        <translation>Schnittdicke in mm</translation>
    </message>
    <message>
        <source>&lt;p&gt;How thick a slice is, mm: its pixels show the mean or the maximum over that thickness. 0 is the plane itself.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Wie dick ein Schnitt ist, in mm: Seine Pixel zeigen den Mittelwert oder das Maximum über diese Dicke. 0 ist die Ebene selbst.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Slab shows</source>
        <translation>Dicker Schnitt zeigt</translation>
    </message>
    <message>
        <source>What a slab shows of the values across it.</source>
        <translation>Was ein dicker Schnitt von den Werten quer zu ihm zeigt.</translation>
    </message>
    <message>
        <source>Tint</source>
        <translation>Färben</translation>
    </message>
    <message>
        <source>&lt;p&gt;Colours slices by the transfer function, as strongly as a centimetre of that tissue is opaque.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Färbt Schnitte nach der Transferfunktion, so stark, wie ein Zentimeter dieses Gewebes deckend ist.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Interpolate between voxels</source>
        <translation>Zwischen Voxeln interpolieren</translation>
    </message>
    <message>
        <source>Crosshair to the middle</source>
        <translation>Fadenkreuz in die Mitte</translation>
    </message>
    <message>
        <source>%1 (W %2 L %3)</source>
        <translation>%1 (W %2 L %3)</translation>
    </message>
    <message>
        <source>As at first</source>
        <translation>Wie anfangs</translation>
    </message>
    <message>
        <source>Full range</source>
        <translation>Voller Wertebereich</translation>
    </message>
    <message>
        <source> mm</source>
        <translation>&#xa0;mm</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Angle (G)</source>
        <translation>Winkel (G)</translation>
    </message>
    <message>
        <source>Ellipse (E)</source>
        <translation>Ellipse (E)</translation>
    </message>
    <message>
        <source>Mark (N)</source>
        <translation>Marke (N)</translation>
    </message>
    <message>
        <source>Left drag: from one end to the corner; then a click sets the other end.</source>
        <translation>Links ziehen: von einem Ende zum Scheitel; danach setzt ein Klick das andere Ende.</translation>
    </message>
    <message>
        <source>Left drag: mean, deviation and area of what lies in an ellipse.</source>
        <translation>Links ziehen: Mittelwert, Streuung und Fläche dessen, was in einer Ellipse liegt.</translation>
    </message>
    <message>
        <source>Click: marks a place with a number; a double click in its list names it.</source>
        <translation>Klick: markiert einen Ort mit einer Nummer; ein Doppelklick in der Liste benennt ihn.</translation>
    </message>
    <message>
        <source>Remove all measurements</source>
        <translation>Alle Messungen löschen</translation>
    </message>
    <message>
        <source>remove all measurements</source>
        <translation>alle Messungen löschen</translation>
    </message>
    <message>
        <source>Outline labels, kept region and crop box</source>
        <translation>Labels, behaltenen Bereich und Zuschnittbox umranden</translation>
    </message>
    <message>
        <source>Labels in their own colours, what is kept in orange, and the crop box in dashed white.</source>
        <translation>Labels in ihren eigenen Farben, was behalten wird, in Orange und der Zuschnitt weiß gestrichelt.</translation>
    </message>
    <message>
        <source>Dark tissue</source>
        <translation>Dunkles Gewebe</translation>
    </message>
    <message>
        <source>Bright tissue</source>
        <translation>Helles Gewebe</translation>
    </message>
</context>
<context>
    <name>limn::PlaneController</name>
    <message>
        <source>&amp;Slices</source>
        <translation>&amp;Schnitte</translation>
    </message>
    <message>
        <source>&amp;3D only</source>
        <translation>Nur &amp;3D</translation>
    </message>
    <message>
        <source>The picture without slices.</source>
        <translation>Das Bild ohne Schnitte.</translation>
    </message>
    <message>
        <source>3D &amp;and slices</source>
        <translation>3D &amp;und Schnitte</translation>
    </message>
    <message>
        <source>Axial, coronal and sagittal slices beside the picture.</source>
        <translation>Axiale, koronare und sagittale Schnitte neben dem Bild.</translation>
    </message>
    <message>
        <source>&amp;One slice large</source>
        <translation>&amp;Ein Schnitt groß</translation>
    </message>
    <message>
        <source>One slice large, the picture and the other slices beside it; a double click on a slice chooses it.</source>
        <translation>Ein Schnitt groß, daneben das Bild und die anderen Schnitte; ein Doppelklick auf einen Schnitt wählt ihn.</translation>
    </message>
</context>
<context>
    <name>limn::PlaneView</name>
    <message>
        <source>%1 slice</source>
        <translation>Schnitt: %1</translation>
    </message>
    <message>
        <source>%1, %2 under the crosshair</source>
        <translation>%1, %2 unter dem Fadenkreuz</translation>
    </message>
    <message>
        <source>&lt;p&gt;The orange line is the edge of what is kept: the rest is hidden or faded.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Die orange Linie ist der Rand dessen, was behalten wird: Der Rest ist ausgeblendet oder blass.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>limn::PointFields</name>
    <message>
        <source>change colour of point</source>
        <translation>Farbe des Punkts ändern</translation>
    </message>
    <message>
        <source>Point %1 of %2</source>
        <translation>Punkt %1 von %2</translation>
    </message>
    <message>
        <source>move point to %1</source>
        <translation>Punkt nach %1 bewegen</translation>
    </message>
    <message>
        <source>set opacity to %1</source>
        <translation>Deckkraft auf %1 setzen</translation>
    </message>
    <message>
        <source>Value of the selected point</source>
        <translation>Wert des gewählten Punkts</translation>
    </message>
    <message>
        <source>Gradient of the selected point</source>
        <translation>Gradient des gewählten Punkts</translation>
    </message>
    <message>
        <source>Opacity of the selected point</source>
        <translation>Deckkraft des gewählten Punkts</translation>
    </message>
    <message>
        <source>Colour of the selected point</source>
        <translation>Farbe des gewählten Punkts</translation>
    </message>
    <message>
        <source>How much tissue of this value hides what lies behind it: 0 (invisible) – 1 (solid), or per cent such as 10 %</source>
        <translation>Wie viel Gewebe dieses Werts von dem verdeckt, was dahinter liegt: 0 (unsichtbar) – 1 (deckend), oder Prozent wie 10&#xa0;%</translation>
    </message>
    <message>
        <source>How much is left of the opacity where the value changes this fast: 0 (none) – 1 (all), or per cent such as 10 %</source>
        <translation>Wie viel von der Deckkraft bleibt, wo sich der Wert so schnell ändert: 0 (nichts) – 1 (alles), oder Prozent wie 10&#xa0;%</translation>
    </message>
    <message>
        <source>The colour in which tissue of this value is drawn</source>
        <translation>Die Farbe, in der Gewebe dieses Werts gezeichnet wird</translation>
    </message>
    <message>
        <source>Several points are selected: move them together in the plot</source>
        <translation>Mehrere Punkte sind gewählt: Bewegen Sie sie gemeinsam in der Kurve</translation>
    </message>
    <message>
        <source>Double click in the plot to add a point</source>
        <translation>Doppelklick: neuer Punkt</translation>
    </message>
    <message>
        <source>Click the curve to add a point</source>
        <translation>Kurve anklicken: neuer Punkt</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>change colour of %1 points</source>
        <translation>Farbe von %1 Punkten ändern</translation>
    </message>
    <message>
        <source>Where the point stands on the axis, between its neighbours</source>
        <translation>Wo der Punkt auf der Achse steht, zwischen seinen Nachbarn</translation>
    </message>
</context>
<context>
    <name>limn::Preset</name>
    <message>
        <source>CT airways</source>
        <translation>CT Atemwege</translation>
    </message>
    <message>
        <source>Airways and bowel; air in the body: windpipe, bronchi, sinuses, bowel</source>
        <translation>Atemwege und Darm; Luft im Körper: Trachea, Bronchien, Nebenhöhlen, Darm</translation>
    </message>
    <message>
        <source>CT angiography</source>
        <translation>CT-Angiografie</translation>
    </message>
    <message>
        <source>Contrast in vessels, bone pale; 150 to 500 HU in red, bone partly transparent</source>
        <translation>Kontrast in Gefäßen, Knochen blass; 150 bis 500&#xa0;HU in Rot, Knochen teils durchsichtig</translation>
    </message>
    <message>
        <source>CT aorta</source>
        <translation>CT Aorta</translation>
    </message>
    <message>
        <source>Aorta, kidneys, bone, stents; from 140 HU on: aneurysms</source>
        <translation>Aorta, Nieren, Knochen, Stents; ab 140&#xa0;HU: Aneurysmen</translation>
    </message>
    <message>
        <source>CT bone</source>
        <translation>CT Knochen</translation>
    </message>
    <message>
        <source>Skull and spine alone, opaque; everything softer is left out</source>
        <translation>Nur Schädel und Wirbelsäule, deckend; alles Weichere fehlt</translation>
    </message>
    <message>
        <source>CT bone and veil</source>
        <translation>CT Knochen, Schleier</translation>
    </message>
    <message>
        <source>Bones in a thin veil of skin; muscle and fat nearly clear</source>
        <translation>Knochen im Schleier der Haut; Muskel und Fett fast durchsichtig</translation>
    </message>
    <message>
        <source>CT bone surface</source>
        <translation>CT Knochenoberfläche</translation>
    </message>
    <message>
        <source>The first surface of bone, opaque</source>
        <translation>Die erste Knochenoberfläche, deckend</translation>
    </message>
    <message>
        <source>CT chest</source>
        <translation>CT Thorax</translation>
    </message>
    <message>
        <source>Ribs and vessels in veils of lung; bones in front of and behind the lungs</source>
        <translation>Rippen, Gefäße im Lungenschleier; Knochen vor und hinter der Lunge</translation>
    </message>
    <message>
        <source>CT coronary arteries</source>
        <translation>CT Koronarien</translation>
    </message>
    <message>
        <source>Fine vessels of the heart; from 150 HU on, bright in front of it</source>
        <translation>Feine Gefäße des Herzens; ab 150&#xa0;HU, hell davor</translation>
    </message>
    <message>
        <source>CT fat</source>
        <translation>CT Fett</translation>
    </message>
    <message>
        <source>Fat alone, in yellow; -140 to -40 HU</source>
        <translation>Nur Fett, in Gelb; −140 bis −40&#xa0;HU</translation>
    </message>
    <message>
        <source>CT heart</source>
        <translation>CT Herz</translation>
    </message>
    <message>
        <source>Heart and great vessels; filled with contrast, muscle behind them</source>
        <translation>Herz und große Gefäße; mit Kontrast gefüllt, dahinter Muskel</translation>
    </message>
    <message>
        <source>CT liver vessels</source>
        <translation>CT Lebergefäße</translation>
    </message>
    <message>
        <source>Vessels of liver and kidneys; veins and arteries with contrast</source>
        <translation>Gefäße von Leber und Nieren; Venen und Arterien mit Kontrast</translation>
    </message>
    <message>
        <source>CT lung</source>
        <translation>CT Lunge</translation>
    </message>
    <message>
        <source>Airways, vessels of the lung; the body around it stays clear</source>
        <translation>Atemwege, Lungengefäße; der Körper darum bleibt durchsichtig</translation>
    </message>
    <message>
        <source>CT lung vessels</source>
        <translation>CT Lungengefäße</translation>
    </message>
    <message>
        <source>Vessels of the lung in red; air left out</source>
        <translation>Lungengefäße in Rot; ohne Luft</translation>
    </message>
    <message>
        <source>CT maximum (MIP)</source>
        <translation>CT Maximum (MIP)</translation>
    </message>
    <message>
        <source>Densest value behind each pixel; in grey: contrast-filled vessels, stones, metal</source>
        <translation>Dichtester Wert je Pixel; in Grau: kontrastierte Gefäße, Steine, Metall</translation>
    </message>
    <message>
        <source>CT muscle</source>
        <translation>CT Muskel</translation>
    </message>
    <message>
        <source>Muscles under transparent skin; bone pale between them</source>
        <translation>Muskeln unter durchsichtiger Haut; Knochen blass dazwischen</translation>
    </message>
    <message>
        <source>CT skin</source>
        <translation>CT Haut</translation>
    </message>
    <message>
        <source>The skin as a closed surface; scars, swellings, what lies on it</source>
        <translation>Haut als geschlossene Fläche; Narben, Schwellungen, Aufliegendes</translation>
    </message>
    <message>
        <source>CT skin and bone</source>
        <translation>CT Haut und Knochen</translation>
    </message>
    <message>
        <source>Skin and muscle over the bones; a veil: compare classic and enhanced here</source>
        <translation>Haut und Muskel über Knochen; ein Schleier: hier Klassisch und Verstärkt vergleichen</translation>
    </message>
    <message>
        <source>CT soft tissue</source>
        <translation>CT Weichteile</translation>
    </message>
    <message>
        <source>Muscle and organs in colour; fat faint, bone pale behind them</source>
        <translation>Muskeln, Organe in Farbe; Fett schwach, Knochen blass dahinter</translation>
    </message>
    <message>
        <source>CT teeth and metal</source>
        <translation>CT Zähne und Metall</translation>
    </message>
    <message>
        <source>Enamel, implants and metal; bone as a shadow</source>
        <translation>Schmelz, Implantate, Metall; Knochen als Schatten</translation>
    </message>
    <message>
        <source>CT X-ray</source>
        <translation>CT Röntgen</translation>
    </message>
    <message>
        <source>How much each ray absorbs; like a radiograph</source>
        <translation>Absorption jedes Strahls; wie ein Röntgenbild</translation>
    </message>
    <message>
        <source>MR glass</source>
        <translation>MR Glas</translation>
    </message>
    <message>
        <source>Tissues as tinted glass; stretched to the brightness of each series</source>
        <translation>Gewebe als farbiges Glas; an die Helligkeit jeder Serie angepasst</translation>
    </message>
    <message>
        <source>MR head</source>
        <translation>MR Kopf</translation>
    </message>
    <message>
        <source>The head with its skin; fitted to the brightness of each series</source>
        <translation>Der Kopf mit seiner Haut; an die Helligkeit jeder Serie angepasst</translation>
    </message>
    <message>
        <source>MR maximum (MIP)</source>
        <translation>MR Maximum (MIP)</translation>
    </message>
    <message>
        <source>Brightest value behind each pixel; in grey, fitted to each series</source>
        <translation>Hellster Wert je Pixel; in Grau, an jede Serie angepasst</translation>
    </message>
    <message>
        <source>MR PD head</source>
        <translation>MR PD-Kopf</translation>
    </message>
    <message>
        <source>The head in proton density; with its skin, fitted to each series</source>
        <translation>Der Kopf in Protonendichte; mit Haut, an jede Serie angepasst</translation>
    </message>
    <message>
        <source>MR T2 head</source>
        <translation>MR T2-Kopf</translation>
    </message>
    <message>
        <source>The head in T2, fluid brightest; with its skin, fitted to each series</source>
        <translation>Kopf in T2, Flüssigkeit hell; mit Haut, an jede Serie angepasst</translation>
    </message>
    <message>
        <source>PET hot spots</source>
        <translation>PET-Anreicherungen</translation>
    </message>
    <message>
        <source>Uptake on a faint body; from dark red to white, fitted to each series</source>
        <translation>Anreicherung, Körper schwach; von Dunkelrot bis Weiß, an jede Serie angepasst</translation>
    </message>
    <message>
        <source>Closed surface</source>
        <translation>Geschlossene Oberfläche</translation>
    </message>
    <message>
        <source>One closed surface; everything brighter than the background, fitted to each series</source>
        <translation>Eine geschlossene Fläche; alles, was heller als der Hintergrund ist, an jede Serie angepasst</translation>
    </message>
    <message>
        <source>Ultrasound surface</source>
        <translation>Ultraschall-Oberfläche</translation>
    </message>
    <message>
        <source>Skin of an unborn child; and other boundaries in fluid, fitted to each series</source>
        <translation>Haut eines Ungeborenen; und andere Grenzflächen in Flüssigkeit, an jede Serie angepasst</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Bright vessels in any scale; MR angiography, subtracted CT, fitted to each series</source>
        <translation>Helle Gefäße jeder Skala; MR-Angiografie, Subtraktions-CT, an jede Serie angepasst</translation>
    </message>
    <message>
        <source>MR skull-stripped brain</source>
        <translation>MR Gehirn ohne Schädel</translation>
    </message>
    <message>
        <source>Of a whole head it shows the scalp; for a brain without its skull, fitted to each series</source>
        <translation>An einem ganzen Kopf zeigt dies die Haut; für ein Gehirn ohne Schädel, an jede Serie angepasst</translation>
    </message>
</context>
<context>
    <name>limn::PresetBrowser</name>
    <message>
        <source>No preset matches</source>
        <translation>Kein Preset passt</translation>
    </message>
    <message>
        <source>Save as preset…</source>
        <translation>Als Preset speichern…</translation>
    </message>
    <message>
        <source>Search presets</source>
        <translation>Presets suchen</translation>
    </message>
    <message>
        <source>Shows only presets whose name, modality or note holds these words (Ctrl+F)</source>
        <translation>Zeigt nur Presets, deren Name, Modalität oder Notiz diese Wörter enthält (Strg+F)</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Presets</translation>
    </message>
    <message>
        <source>Keeps the present curve and light under a name of your own</source>
        <translation>Speichert die jetzige Kurve und das jetzige Licht unter einem eigenen Namen</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Als Preset speichern</translation>
    </message>
    <message>
        <source>Delete preset</source>
        <translation>Preset löschen</translation>
    </message>
    <message>
        <source>Only presets of your own can be deleted: choose one first</source>
        <translation>Nur eigene Presets lassen sich löschen: Wählen Sie zuerst eines</translation>
    </message>
    <message>
        <source>Deletes the preset &quot;%1&quot;</source>
        <translation>Löscht das Preset „%1“</translation>
    </message>
    <message>
        <source>Large pictures</source>
        <translation>Große Bilder</translation>
    </message>
    <message>
        <source>Shows the presets as large pictures instead of a list</source>
        <translation>Zeigt die Presets als große Bilder statt als Liste</translation>
    </message>
</context>
<context>
    <name>limn::PresetController</name>
    <message>
        <source>use preset %1</source>
        <translation>Preset %1 verwenden</translation>
    </message>
    <message>
        <source>fit preset %1</source>
        <translation>Preset %1 anpassen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was fitted by this volume&apos;s own values: air lies at %2 (instead of %3 HU), tissue begins at %4 (%5 HU), the brightest is %6 (%7 HU).</source>
        <translation>„%1“ wurde nach den Werten dieses Volumens angepasst: Luft liegt bei %2 (statt %3&#xa0;HU), Gewebe beginnt bei %4 (%5&#xa0;HU), das Hellste liegt bei %6 (%7&#xa0;HU).</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is made for Hounsfield units, which this volume does not have: it may show nothing, or the wrong tissue.</source>
        <translation>„%1“ ist für Hounsfield-Einheiten gemacht, die dieses Volumen nicht hat: Es zeigt vielleicht nichts oder das falsche Gewebe.</translation>
    </message>
    <message>
        <source>Fit to this volume</source>
        <translation>An dieses Volumen anpassen</translation>
    </message>
    <message>
        <source>use the full range</source>
        <translation>vollen Wertebereich verwenden</translation>
    </message>
    <message>
        <source>My preset</source>
        <translation>Mein Preset</translation>
    </message>
    <message>
        <source>My %1</source>
        <translation>%1 (eigenes)</translation>
    </message>
    <message>
        <source>Use it as it is</source>
        <translation>Unverändert verwenden</translation>
    </message>
    <message>
        <source>P&amp;resets</source>
        <translation>&amp;Presets</translation>
    </message>
    <message>
        <source>&amp;Find preset</source>
        <translation>Preset &amp;suchen</translation>
    </message>
    <message>
        <source>&amp;Keep my light</source>
        <translation>Mein &amp;Licht behalten</translation>
    </message>
    <message>
        <source>Presets leave light, highlights and boundaries as they are; the curve and what a ray shows are the preset&apos;s.</source>
        <translation>Presets lassen Licht, Glanz und Grenzen, wie sie sind; Kurve und Projektion sind die des Presets.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; shows nothing of this volume: its curve is for other values.</source>
        <translation>„%1“ zeigt nichts von diesem Volumen: Die Kurve gilt für andere Werte.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; shapes the curve in hand, of one label or piece; the picture&apos;s other curves stay.</source>
        <translation>„%1“ formt die Kurve in der Hand, die eines Labels oder Teils; die anderen Kurven des Bildes bleiben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was fitted to this volume&apos;s values.</source>
        <translation>„%1“ wurde an die Werte dieses Volumens angepasst.</translation>
    </message>
    <message>
        <source>Use as saved</source>
        <translation>Wie gespeichert verwenden</translation>
    </message>
    <message>
        <source>use preset %1 as it is</source>
        <translation>Preset %1 unverändert verwenden</translation>
    </message>
    <message>
        <source>use preset %1 as saved</source>
        <translation>Preset %1 wie gespeichert verwenden</translation>
    </message>
</context>
<context>
    <name>limn::ProfileChart</name>
    <message>
        <source>Value, opacity and share of the light along the ray</source>
        <translation>Wert, Deckkraft und Anteil am Licht entlang des Strahls</translation>
    </message>
</context>
<context>
    <name>limn::ProjectionSection</name>
    <message>
        <source>Tissue (composite)</source>
        <translation>Gewebe (Komposition)</translation>
    </message>
    <message>
        <source>Maximum (MIP)</source>
        <translation>Maximum (MIP)</translation>
    </message>
    <message>
        <source>Minimum (MinIP)</source>
        <translation>Minimum (MinIP)</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgen</translation>
    </message>
    <message>
        <source>Surface (isosurface)</source>
        <translation>Oberfläche (Isofläche)</translation>
    </message>
    <message>
        <source>The largest value along each ray: contrast-filled vessels, calcium, metal. Depth is lost.</source>
        <translation>Der größte Wert entlang jedes Strahls: kontrastierte Gefäße, Kalk, Metall. Die Tiefe geht verloren.</translation>
    </message>
    <message>
        <source>The smallest value along each ray: airways, air trapping. Black where the curve is transparent at that value; crop the air around the body.</source>
        <translation>Der kleinste Wert entlang jedes Strahls: Atemwege, Air-Trapping. Schwarz, wo die Kurve bei diesem Wert durchsichtig ist; schneiden Sie die Luft um den Körper weg.</translation>
    </message>
    <message>
        <source>The mean value along each ray, like one thick slice. Air lowers the mean: make the curve opaque at lower values, or crop.</source>
        <translation>Der mittlere Wert entlang jedes Strahls, wie ein dicker Schnitt. Luft senkt den Mittelwert: Machen Sie die Kurve bei kleineren Werten deckend, oder schneiden Sie zu.</translation>
    </message>
    <message>
        <source>White where much is opaque along the ray, as on a radiograph. Lower the overall opacity where all is white.</source>
        <translation>Weiß, wo entlang des Strahls viel deckt, wie auf einem Röntgenbild. Verringern Sie die Gesamtdeckkraft, wenn alles weiß ist.</translation>
    </message>
    <message>
        <source>The first surface at the value below, solid and lit.</source>
        <translation>Die erste Oberfläche beim unten gewählten Wert, deckend und beleuchtet.</translation>
    </message>
    <message>
        <source>Surface at</source>
        <translation>Oberflächenwert</translation>
    </message>
    <message>
        <source>The value at which the surface lies: 300 HU is bone, −300 HU the skin of a CT.</source>
        <translation>Der Wert, bei dem die Oberfläche liegt: 300&#xa0;HU ist Knochen, −300&#xa0;HU die Haut im CT.</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>Projektionsart</translation>
    </message>
    <message>
        <source>What each ray through the volume becomes in the picture.</source>
        <translation>Was jeder Strahl durch das Volumen im Bild ergibt.</translation>
    </message>
    <message>
        <source>Surface and tissue</source>
        <translation>Oberfläche und Gewebe</translation>
    </message>
    <message>
        <source>Tissue as the opacity curve shows it, lit; what is near hides what lies behind it.</source>
        <translation>Gewebe, wie die Deckkraftkurve es zeigt, beleuchtet; was nahe ist, verdeckt, was dahinter liegt.</translation>
    </message>
    <message>
        <source>Hybrid: a solid surface at the value below, seen through the tissue before it.</source>
        <translation>Hybrid: eine deckende Oberfläche beim unten gewählten Wert, gesehen durch das Gewebe davor.</translation>
    </message>
    <message>
        <source>Value of the surface</source>
        <translation>Wert der Oberfläche</translation>
    </message>
</context>
<context>
    <name>limn::PropertiesPanel</name>
    <message>
        <source>unused: this projection is unlit</source>
        <translation>Projektion ohne Licht</translation>
    </message>
</context>
<context>
    <name>limn::QualitySection</name>
    <message>
        <source>Step</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>The distance between samples along a ray, in voxels: smaller is closer to exact, larger is faster.</source>
        <translation>Der Abstand der Abtastpunkte entlang eines Strahls, in Voxeln: kleiner ist genauer, größer ist schneller.</translation>
    </message>
    <message>
        <source>voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Stop when opaque to</source>
        <translation>Ende bei Deckkraft</translation>
    </message>
    <message>
        <source>A ray stops where so much light is already blocked: lower is faster but loses a little light, 1 never stops early.</source>
        <translation>Ein Strahl endet, wo schon so viel Licht verdeckt ist: kleiner ist schneller, verliert aber etwas Licht; 1 endet nie vorzeitig.</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Curve between samples</source>
        <translation>Kurve zwischen Abtastpunkten</translation>
    </message>
    <message>
        <source>Whether the curve is averaged from one sample to the next (pre-integration), so that narrow peaks are not stepped over; automatic does so where the step is too large for the curve.</source>
        <translation>Ob die Kurve von einem Abtastpunkt zum nächsten gemittelt wird (Vorintegration), sodass schmale Spitzen nicht übersprungen werden; „Automatisch“ tut es, wo der Schritt für die Kurve zu groß ist.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Always averaged</source>
        <translation>Immer mitteln</translation>
    </message>
    <message>
        <source>Never averaged</source>
        <translation>Nie mitteln</translation>
    </message>
    <message>
        <source>Shift the samples (jitter)</source>
        <translation>Schritte verwischen (Jitter)</translation>
    </message>
    <message>
        <source>&lt;p&gt;Shifts each pixel&apos;s samples by a fixed random part of a step: rings from a large step turn into fine grain.&lt;/p&gt;&lt;p&gt;On or off, default off.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Verschiebt die Abtastpunkte jedes Pixels um einen festen zufälligen Teil eines Schritts: Ringe durch große Schritte werden zu feinem Korn.&lt;/p&gt;&lt;p&gt;An oder aus, Standard aus.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Step between samples</source>
        <translation>Schritt zwischen Abtastpunkten</translation>
    </message>
    <message>
        <source>Opacity at which rays stop</source>
        <translation>Deckkraft, bei der Strahlen enden</translation>
    </message>
    <message>
        <source>voxel</source>
        <translation>Voxel</translation>
    </message>
</context>
<context>
    <name>limn::RangeSlider</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
</context>
<context>
    <name>limn::RayController</name>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Ra&amp;y</source>
        <translation>Str&amp;ahl</translation>
    </message>
</context>
<context>
    <name>limn::RayPanel</name>
    <message>
        <source>Go to that depth</source>
        <translation>Zu dieser Tiefe</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>Strahl</translation>
    </message>
    <message>
        <source>&lt;p&gt;The crosshair goes to where half of the light is gathered, in the slices and in the picture.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Das Fadenkreuz geht dorthin, wo die Hälfte des Lichts gesammelt ist, in den Schnitten und im Bild.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No ray is read. Hold Shift over the picture: what lies along the ray below the pointer shows here, and stays.</source>
        <translation>Noch wird kein Strahl gelesen. Halten Sie über dem Bild die Umschalttaste gedrückt: Was entlang des Strahls unter dem Zeiger liegt, erscheint hier und bleibt.</translation>
    </message>
    <message>
        <source>Point at the chart to read a depth; a click goes there.</source>
        <translation>Zeigen Sie ins Diagramm, um eine Tiefe abzulesen; ein Klick geht dorthin.</translation>
    </message>
</context>
<context>
    <name>limn::RecentMenu</name>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>&amp;Remove from this list</source>
        <translation>Aus dieser Liste &amp;entfernen</translation>
    </message>
</context>
<context>
    <name>limn::RegionController</name>
    <message>
        <source>Open the labels of this volume</source>
        <translation>Labels dieses Volumens öffnen</translation>
    </message>
    <message>
        <source>Segmentations (*.nrrd *.nhdr *.nii *.nii.gz *.dcm *.mha *.mhd *.vti *.vtk)</source>
        <translation>Segmentierungen (*.nrrd *.nhdr *.nii *.nii.gz *.dcm *.mha *.mhd *.vti *.vtk)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Opening labels</source>
        <translation>Labels werden geöffnet</translation>
    </message>
    <message>
        <source>open labels</source>
        <translation>Labels öffnen</translation>
    </message>
    <message>
        <source>body only</source>
        <translation>nur Körper</translation>
    </message>
    <message>
        <source>Looking for the body</source>
        <translation>Körper wird gesucht</translation>
    </message>
    <message>
        <source>show everything</source>
        <translation>alles zeigen</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Open &amp;labels…</source>
        <translation>&amp;Labels öffnen…</translation>
    </message>
    <message>
        <source>&amp;Body only</source>
        <translation>Nur &amp;Körper</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Open a folder of mas&amp;ks…</source>
        <translation>Ordner mit Mas&amp;ken öffnen…</translation>
    </message>
    <message>
        <source>Opens a segmentation that has a file for each structure, as TotalSegmentator writes it: each becomes a label, called after its file.</source>
        <translation>Öffnet eine Segmentierung mit einer Datei je Struktur, wie TotalSegmentator sie schreibt: Jede wird ein Label mit dem Namen ihrer Datei.</translation>
    </message>
    <message>
        <source>Open a folder of masks of this volume</source>
        <translation>Ordner mit Masken dieses Volumens öffnen</translation>
    </message>
    <message>
        <source>Open it as a volume</source>
        <translation>Als Volumen öffnen</translation>
    </message>
    <message>
        <source>Finds the body and hides the table, the head holder and what else lies beside it; labels that are open stay open.</source>
        <translation>Findet den Körper und blendet Tisch, Kopfhalterung und anderes daneben aus; geöffnete Labels bleiben offen.</translation>
    </message>
    <message>
        <source>open labels of %1 files</source>
        <translation>Labels aus %1 Dateien öffnen</translation>
    </message>
    <message>
        <source>open labels %1</source>
        <translation>Labels %1 öffnen</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 Dateien</translation>
    </message>
    <message>
        <source>Opens a segmentation of the volume, or the masks of several files at once: each label can be shown, hidden or faded.</source>
        <translation>Öffnet eine Segmentierung des Volumens oder die Masken mehrerer Dateien auf einmal: Jedes Label lässt sich zeigen, ausblenden oder abschwächen.</translation>
    </message>
    <message>
        <source>labels of before</source>
        <translation>Labels von vorher</translation>
    </message>
    <message>
        <source>The labels of %1 took the place of those of %2.</source>
        <translation>Die Labels von %1 sind an die Stelle derer von %2 getreten.</translation>
    </message>
    <message>
        <source>Bring those back</source>
        <translation>Jene zurückholen</translation>
    </message>
    <message>
        <source>one file</source>
        <translation>einer Datei</translation>
    </message>
    <message>
        <source>Smaller ones on top</source>
        <translation>Kleinere obenauf</translation>
    </message>
    <message>
        <source>smaller labels on top</source>
        <translation>kleinere Labels obenauf</translation>
    </message>
    <message>
        <source>show what was cut away</source>
        <translation>Weggeschnittenes zeigen</translation>
    </message>
</context>
<context>
    <name>limn::RegionOffers</name>
    <message>
        <source>body only</source>
        <translation>nur Körper</translation>
    </message>
    <message>
        <source>The volume before lies on the same grid and was cut by hand.</source>
        <translation>Das vorige Volumen liegt auf demselben Gitter und wurde von Hand beschnitten.</translation>
    </message>
    <message>
        <source>Cut this one likewise</source>
        <translation>Dieses ebenso schneiden</translation>
    </message>
    <message>
        <source>cuts of the volume before</source>
        <translation>Schnitte des vorigen Volumens</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Jetzt nicht</translation>
    </message>
    <message>
        <source>Hide the table and the holder? It is not certain which part is the body.</source>
        <translation>Tisch und Halterung ausblenden? Es ist nicht sicher, welcher Teil der Körper ist.</translation>
    </message>
    <message>
        <source>Hide them</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Leave them</source>
        <translation>So lassen</translation>
    </message>
</context>
<context>
    <name>limn::RemarksController</name>
    <message>
        <source>Set spacing…</source>
        <translation>Voxelabstand festlegen…</translation>
    </message>
    <message>
        <source>Set orientation…</source>
        <translation>Orientierung festlegen…</translation>
    </message>
    <message>
        <source>Beside this series lies a look that belongs to it.</source>
        <translation>Neben dieser Serie liegt eine Darstellung, die zu ihr gehört.</translation>
    </message>
    <message>
        <source>Beside this series lie %1 looks that belong to it; this is the newest.</source>
        <translation>Neben dieser Serie liegen %1 Darstellungen, die zu ihr gehören; dies ist die neueste.</translation>
    </message>
    <message>
        <source>Show the look</source>
        <translation>Darstellung zeigen</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Jetzt nicht</translation>
    </message>
    <message>
        <source>Open its folder</source>
        <translation>Seinen Ordner öffnen</translation>
    </message>
    <message>
        <source>Show the figure</source>
        <translation>Abbildung zeigen</translation>
    </message>
</context>
<context>
    <name>limn::SavingController</name>
    <message>
        <source>Save the session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>The picture is not complete yet; save it again once it is.</source>
        <translation>Das Bild ist noch nicht fertig; speichern Sie es noch einmal, sobald es das ist.</translation>
    </message>
    <message>
        <source>Limn session (*.limn.json)</source>
        <translation>Limn-Sitzung (*.limn.json)</translation>
    </message>
    <message>
        <source>Any JSON file (*.json)</source>
        <translation>Beliebige JSON-Datei (*.json)</translation>
    </message>
    <message>
        <source>Save look and camera</source>
        <translation>Darstellung und Kamera speichern</translation>
    </message>
    <message>
        <source>Limn scene (*.limn.json)</source>
        <translation>Limn-Szene (*.limn.json)</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>Si&amp;tzung speichern</translation>
    </message>
    <message>
        <source>Saves all of your work but the volume itself: look and camera, comparison, slices and panels.</source>
        <translation>Speichert Ihre ganze Arbeit außer dem Volumen selbst: Darstellung und Kamera, Vergleich, Schnitte und Bereiche.</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>Sitzung speichern &amp;als…</translation>
    </message>
    <message>
        <source>Save look and ca&amp;mera (scene)…</source>
        <translation>Darstellung und Kamera speichern (S&amp;zene)…</translation>
    </message>
    <message>
        <source>Saves how the volume is shown: curve, light, camera, crop. For another volume, or for the command line.</source>
        <translation>Speichert, wie das Volumen gezeigt wird: Kurve, Licht, Kamera, Zuschnitt. Für ein anderes Volumen oder für die Kommandozeile.</translation>
    </message>
    <message>
        <source>Drawing %1, %2 × %3 pixels</source>
        <translation>%1 wird gezeichnet, %2 × %3 Pixel</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2&#xa0;%</translation>
    </message>
    <message>
        <source>Save elsewhere…</source>
        <translation>Anderswo speichern…</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Replace the changed session?</source>
        <translation>Geänderte Sitzung ersetzen?</translation>
    </message>
    <message>
        <source>Replacing it loses what was saved there; another name keeps both.</source>
        <translation>Ersetzen verwirft, was dort gespeichert wurde; ein anderer Name behält beides.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>%1 was changed elsewhere since it was opened or saved here.</source>
        <translation>%1 wurde anderswo geändert, seit es hier geöffnet oder gespeichert wurde.</translation>
    </message>
    <message>
        <source>Lost, because the memory kept for pictures that could not be written is full of later ones: %1.</source>
        <translation>Verloren, weil der Speicher für nicht geschriebene Bilder voll von späteren ist: %1.</translation>
    </message>
    <message>
        <source>Too late to cancel: the file is being written.</source>
        <translation>Zum Abbrechen ist es zu spät: Die Datei wird geschrieben.</translation>
    </message>
</context>
<context>
    <name>limn::SearchField</name>
    <message>
        <source>Clear the search</source>
        <translation>Suche leeren</translation>
    </message>
</context>
<context>
    <name>limn::SeriesDialog</name>
    <message>
        <source>Choose a series</source>
        <translation>Serie wählen</translation>
    </message>
    <message>
        <source>This folder holds %1 series, the largest first.</source>
        <translation>Dieser Ordner enthält %1 Serien, die größte zuerst.</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serien</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Schichtdicke</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
</context>
<context>
    <name>limn::SessionSafety</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>The changes to this session are not saved, and Limn cannot keep them for you.</source>
        <translation>Die Änderungen an dieser Sitzung sind nicht gespeichert, und Limn kann sie nicht für Sie aufbewahren.</translation>
    </message>
    <message>
        <source>Save session…</source>
        <translation>Sitzung speichern…</translation>
    </message>
    <message>
        <source>Lose the changes</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Unsaved work is not safe at present. %1</source>
        <translation>Ungespeicherte Arbeit ist derzeit nicht sicher. %1</translation>
    </message>
    <message>
        <source>Limn ended unexpectedly. Restore the last session (%1)?</source>
        <translation>Limn wurde unerwartet beendet. Letzte Sitzung wiederherstellen (%1)?</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Open &amp;unsaved session</source>
        <translation>&amp;Ungespeicherte Sitzung öffnen</translation>
    </message>
    <message>
        <source>Sessions that were left with unsaved changes.</source>
        <translation>Sitzungen, die mit ungespeicherten Änderungen verlassen wurden.</translation>
    </message>
    <message>
        <source>Your work on %1 is kept.</source>
        <translation>Ihre Arbeit an %1 wird aufbewahrt.</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Your earlier work on this volume (%1) is kept.</source>
        <translation>Ihre frühere Arbeit an diesem Volumen (%1) wird aufbewahrt.</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Your earlier work on this volume (%1) is kept, and so is your work on %2.</source>
        <translation>Ihre frühere Arbeit an diesem Volumen (%1) wird aufbewahrt, ebenso Ihre Arbeit an %2.</translation>
    </message>
    <message>
        <source>Bring back the other</source>
        <translation>Die andere zurückholen</translation>
    </message>
</context>
<context>
    <name>limn::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>limn::ShadingSection</name>
    <message>
        <source>The left side alone uses this, and keeps its look: swap the sides to edit it.</source>
        <translation>Nur die linke Seite verwendet dies und behält ihre Darstellung: Tauschen Sie die Seiten, um sie zu bearbeiten.</translation>
    </message>
</context>
<context>
    <name>limn::SliceSaving</name>
    <message>
        <source>Copied the slice, %1 × %2 pixels.</source>
        <translation>Schicht kopiert, %1 × %2 Pixel.</translation>
    </message>
    <message>
        <source>Another slice is being written; save this one once it is there.</source>
        <translation>Eine andere Schicht wird noch geschrieben; speichern Sie diese, sobald jene da ist.</translation>
    </message>
    <message>
        <source>Save the slice</source>
        <translation>Schicht speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif)</source>
        <translation>Bilder (*.png *.tif)</translation>
    </message>
</context>
<context>
    <name>limn::StabilityDialog</name>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>Stability checks</source>
        <translation>Stabilitätsprüfungen</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>The checks could not be started: %1.</source>
        <translation>Die Prüfungen konnten nicht gestartet werden: %1.</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Prüfung läuft…</translation>
    </message>
    <message>
        <source>The checks ended before they were complete, by you or by the driver.</source>
        <translation>Die Prüfungen endeten vorzeitig, durch Sie oder durch den Treiber.</translation>
    </message>
    <message>
        <source>Checks the graphics driver of this computer with pictures whose right result is known. Takes some minutes; you can go on working.</source>
        <translation>Prüft den Grafiktreiber dieses Rechners mit Bildern, deren richtiges Ergebnis bekannt ist. Das dauert einige Minuten; Sie können weiterarbeiten.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Running checks go on.</source>
        <translation>Laufende Prüfungen gehen weiter.</translation>
    </message>
</context>
<context>
    <name>limn::SuggestionController</name>
    <message>
        <source>Boundaries cannot be looked for: %1.</source>
        <translation>Grenzflächen können nicht gesucht werden: %1.</translation>
    </message>
    <message>
        <source>use the band %1</source>
        <translation>Band %1 verwenden</translation>
    </message>
    <message>
        <source>S&amp;uggest from boundaries…</source>
        <translation>Aus &amp;Grenzflächen vorschlagen…</translation>
    </message>
    <message>
        <source>Finds where materials touch in this volume and proposes a band of the curve for each</source>
        <translation>Findet, wo in diesem Volumen Materialien aneinandergrenzen, und schlägt für jede Grenzfläche ein Band der Kurve vor</translation>
    </message>
</context>
<context>
    <name>limn::SuggestionDialog</name>
    <message>
        <source>Suggested bands</source>
        <translation>Vorgeschlagene Bänder</translation>
    </message>
    <message>
        <source>Looking for boundaries</source>
        <translation>Grenzflächen werden gesucht</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Looking for where materials touch…</source>
        <translation>Es wird gesucht, wo Materialien aneinandergrenzen…</translation>
    </message>
    <message>
        <source>Nothing in this volume has a boundary that stands out.</source>
        <translation>Nichts in diesem Volumen hat eine Grenzfläche, die hervortritt.</translation>
    </message>
    <message>
        <source>In the curve</source>
        <translation>In der Kurve</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>Use the band %1</source>
        <translation>Band %1 verwenden</translation>
    </message>
    <message>
        <source>Each band makes one boundary visible, and the uppermost all beyond it; those that stand out most come first. Point at a row to see it in the picture; Use puts it into the curve, in one step of the history.</source>
        <translation>Jedes Band macht eine Grenzfläche sichtbar, das oberste auch alles darüber; was am deutlichsten ist, steht zuerst. Zeigen Sie auf eine Zeile, um sie im Bild zu sehen; „Verwenden“ setzt das Band in die Kurve, als ein Schritt des Verlaufs.</translation>
    </message>
</context>
<context>
    <name>limn::SurfaceDialog</name>
    <message>
        <source>&amp;Close holes where crop or volume end (printing needs it)</source>
        <translation>Löcher an Zuschnitt und Volumenende s&amp;chließen (zum Drucken nötig)</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>Export a surface</source>
        <translation>Oberfläche exportieren</translation>
    </message>
    <message>
        <source>Specks that enclose less are left out, and smaller hollows filled; 0 keeps all.</source>
        <translation>Teilchen, die weniger umschließen, fallen weg, und kleinere Hohlräume werden gefüllt; 0 behält alles.</translation>
    </message>
    <message>
        <source>Triangles are taken away as far as this distance from the isosurface allows; 0 keeps all.</source>
        <translation>Dreiecke fallen weg, soweit dieser Abstand von der Isofläche es erlaubt; 0 behält alle.</translation>
    </message>
    <message>
        <source>As fine as the voxels</source>
        <translation>So fein wie die Voxel</translation>
    </message>
    <message>
        <source>Twice as fine (4 times the triangles)</source>
        <translation>Doppelt so fein (4-mal so viele Dreiecke)</translation>
    </message>
    <message>
        <source>3 times as fine (9 times the triangles)</source>
        <translation>3-mal so fein (9-mal so viele Dreiecke)</translation>
    </message>
    <message>
        <source>Value of the surface</source>
        <translation>Wert der Oberfläche</translation>
    </message>
    <message>
        <source>Smallest part in cubic millimetres</source>
        <translation>Kleinster Teil in Kubikmillimetern</translation>
    </message>
    <message>
        <source>Distance from the isosurface in millimetres</source>
        <translation>Abstand von der Isofläche in Millimetern</translation>
    </message>
    <message>
        <source>Making the surface</source>
        <translation>Oberfläche wird berechnet</translation>
    </message>
    <message>
        <source>&amp;Value</source>
        <translation>&amp;Wert</translation>
    </message>
    <message>
        <source>Leave out &amp;parts below</source>
        <translation>&amp;Teile weglassen unter</translation>
    </message>
    <message>
        <source>mm³</source>
        <translation>mm³</translation>
    </message>
    <message>
        <source>&amp;Simplify within</source>
        <translation>&amp;Vereinfachen bis auf</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>&amp;Detail</source>
        <translation>&amp;Details</translation>
    </message>
    <message>
        <source>Making the surface and measuring it…</source>
        <translation>Oberfläche wird berechnet und vermessen…</translation>
    </message>
    <message>
        <source>Flat faces close the surface where the crop, the volume or what is kept of it ends.</source>
        <translation>Ebene Flächen schließen die Oberfläche, wo der Zuschnitt, das Volumen oder der behaltene Bereich endet.</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Abgebrochen; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>E&amp;xport surface…</source>
        <translation>Oberfläche e&amp;xportieren…</translation>
    </message>
    <message>
        <source>Makes a mesh of the surface at a value, to print or to model with: STL, PLY or OBJ, in millimetres.</source>
        <translation>Macht aus der Fläche bei einem Wert ein Dreiecksnetz zum Drucken oder Modellieren: STL, PLY oder OBJ, in Millimetern.</translation>
    </message>
    <message>
        <source>Counting triangles…</source>
        <translation>Dreiecke werden gezählt…</translation>
    </message>
    <message>
        <source>Export the surface</source>
        <translation>Oberfläche exportieren</translation>
    </message>
    <message>
        <source>STL, for printing (*.stl)</source>
        <translation>STL, zum Drucken (*.stl)</translation>
    </message>
    <message>
        <source>PLY, with normals (*.ply)</source>
        <translation>PLY, mit Normalen (*.ply)</translation>
    </message>
    <message>
        <source>OBJ, with normals (*.obj)</source>
        <translation>OBJ, mit Normalen (*.obj)</translation>
    </message>
</context>
<context>
    <name>limn::TissueButtons</name>
    <message>
        <source>Less</source>
        <translation>Weniger</translation>
    </message>
    <message>
        <source>Halves the opacity around the pinned value</source>
        <translation>Halbiert die Deckkraft um den angehefteten Wert</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Doubles the opacity around the pinned value</source>
        <translation>Verdoppelt die Deckkraft um den angehefteten Wert</translation>
    </message>
    <message>
        <source>Pinned: %1, %2</source>
        <translation>Angeheftet: %1, %2</translation>
    </message>
    <message>
        <source>Pinned: %1</source>
        <translation>Angeheftet: %1</translation>
    </message>
    <message>
        <source>%1 of the pinned tissue</source>
        <comment>less or more</comment>
        <translation>%1 vom angehefteten Gewebe</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>less or more, a value</comment>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>limn::TitleController</name>
    <message>
        <source>This volume carries its patient&apos;s name. Show it in the title bar?</source>
        <translation>Dieses Volumen enthält den Namen des Patienten. In der Titelleiste zeigen?</translation>
    </message>
    <message>
        <source>Name the patient</source>
        <translation>Namen zeigen</translation>
    </message>
    <message>
        <source>Do not show it</source>
        <translation>Nicht zeigen</translation>
    </message>
    <message>
        <source>Show the patient&apos;s &amp;name in the title bar</source>
        <translation>Patienten&amp;namen in der Titelleiste zeigen</translation>
    </message>
</context>
<context>
    <name>limn::TourController</name>
    <message>
        <source>New to Limn? A tour shows the window in six short steps.</source>
        <translation>Neu bei Limn? Ein Rundgang zeigt das Fenster in sechs kurzen Schritten.</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Rundgang beginnen</translation>
    </message>
    <message>
        <source>No, thank you</source>
        <translation>Nein, danke</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open a DICOM folder or a file here, or drop one on the window. To look around first, take the sample head.</source>
        <translation>Hier einen DICOM-Ordner oder eine Datei öffnen, oder aufs Fenster ziehen. Wer sich erst umsehen will, nimmt den Beispielkopf.</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <source>Shape the curve</source>
        <translation>Die Kurve formen</translation>
    </message>
    <message>
        <source>Choose a preset</source>
        <translation>Ein Preset wählen</translation>
    </message>
    <message>
        <source>Each shows what it makes of your volume. Point at one to try it, click to use it. 1 to 9 in the picture are the first of the list.</source>
        <translation>Jedes zeigt, was es aus dem Volumen macht. Daraufzeigen probiert es aus, ein Klick nimmt es. 1 bis 9 im Bild sind die ersten der Liste.</translation>
    </message>
    <message>
        <source>Light and accuracy</source>
        <translation>Licht und Genauigkeit</translation>
    </message>
    <message>
        <source>Properties has projection, light and crop; Effects lists what is computed and why; Accuracy measures what exactness costs in time. The line below says how exact the picture is.</source>
        <translation>Eigenschaften hat Projektion, Licht und Zuschnitt; Effekte zeigt, was warum berechnet wird; Genauigkeit misst, was sie an Zeit kostet. Die Zeile unten sagt, wie genau das Bild ist.</translation>
    </message>
    <message>
        <source>Save, and find help</source>
        <translation>Speichern und Hilfe finden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Open the sample head</source>
        <translation>Den Beispielkopf öffnen</translation>
    </message>
    <message>
        <source>The curve says how solid each value is; behind it stands how often each occurs. Drag a point, or click the curve to add one: the picture follows. Ctrl+Z takes back what you did to the picture.</source>
        <translation>Die Kurve sagt, wie deckend jeder Wert ist; dahinter steht, wie oft er vorkommt. Einen Punkt ziehen, oder auf die Kurve klicken für einen neuen: Das Bild folgt. Strg+Z nimmt zurück, was am Bild geändert wurde.</translation>
    </message>
    <message>
        <source>&amp;Tour of the window</source>
        <translation>&amp;Rundgang durch das Fenster</translation>
    </message>
    <message>
        <source>View ▸ Side by side compares two ways of showing a volume.</source>
        <translation>Ansicht ▸ Nebeneinander vergleicht zwei Darstellungen eines Volumens.</translation>
    </message>
    <message>
        <source>The colours show where &quot;%1&quot; and &quot;%2&quot; differ.</source>
        <translation>Die Farben zeigen, wo sich „%1“ und „%2“ unterscheiden.</translation>
    </message>
    <message>
        <source>At the left you see &quot;%1&quot;, at the right &quot;%2&quot;; Space swaps them while held.</source>
        <translation>Links sehen Sie „%1“, rechts „%2“; die Leertaste tauscht beide, solange sie gedrückt ist.</translation>
    </message>
    <message>
        <source>The camera, here behind », saves the picture with everything that made it.</source>
        <translation>Die Kamera, hier hinter », speichert das Bild mit allem, was es ausmacht.</translation>
    </message>
    <message>
        <source>The camera saves the picture with everything that made it.</source>
        <translation>Die Kamera speichert das Bild mit allem, was es ausmacht.</translation>
    </message>
    <message>
        <source>File ▸ Save picture saves the picture with everything that made it.</source>
        <translation>Datei ▸ Bild speichern speichert das Bild mit allem, was es ausmacht.</translation>
    </message>
    <message>
        <source>File has figures, sessions and more. F1 opens the guide, ? lists every key, and Help has this tour again.</source>
        <translation>Datei hat Abbildungen, Sitzungen und mehr. F1 öffnet den Leitfaden, ? zeigt alle Tasten, und Hilfe hat diesen Rundgang noch einmal.</translation>
    </message>
    <message>
        <source>Drag with the left button to turn, turn the wheel to come nearer. %1 Esc always returns to turning.</source>
        <translation>Mit der linken Taste ziehen dreht, das Rad holt näher heran. %1 Esc kehrt immer zum Drehen zurück.</translation>
    </message>
</context>
<context>
    <name>limn::TransferFunctionCanvas</name>
    <message>
        <source>Opacity of point %1</source>
        <translation>Deckkraft von Punkt %1</translation>
    </message>
    <message>
        <source>Point %1 of %2</source>
        <translation>Punkt %1 von %2</translation>
    </message>
    <message>
        <source>%1, opacity %2</source>
        <translation>%1, Deckkraft %2</translation>
    </message>
    <message>
        <source>Transfer function curve</source>
        <translation>Kurve der Transferfunktion</translation>
    </message>
    <message>
        <source>Curve of opacity over the gradient</source>
        <translation>Kurve der Deckkraft über dem Gradienten</translation>
    </message>
    <message>
        <source>Tab walks the points, arrows move them, N adds one, Enter edits numbers, Delete removes, Ctrl+A selects all.</source>
        <translation>Tab geht durch die Punkte, Pfeiltasten bewegen sie, N fügt einen hinzu, Eingabe ändert Zahlen, Entf löscht, Strg+A wählt alle.</translation>
    </message>
    <message>
        <source>Open a volume to see its histogram</source>
        <translation>Öffnen Sie ein Volumen, um sein Histogramm zu sehen</translation>
    </message>
    <message>
        <source>Delete %1 points</source>
        <translation>%1 Punkte löschen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Colour and numbers…</source>
        <translation>Farbe und Zahlen…</translation>
    </message>
    <message>
        <source>Numbers…</source>
        <translation>Zahlen…</translation>
    </message>
    <message>
        <source>Add point here</source>
        <translation>Punkt hier hinzufügen</translation>
    </message>
    <message>
        <source>Select all points</source>
        <translation>Alle Punkte wählen</translation>
    </message>
    <message>
        <source>Show all values</source>
        <translation>Alle Werte zeigen</translation>
    </message>
    <message>
        <source>Remove the pin</source>
        <translation>Anheftung lösen</translation>
    </message>
</context>
<context>
    <name>limn::TransferFunctionEditor</name>
    <message>
        <source>Overall opacity</source>
        <translation>Gesamtdeckkraft</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>&lt;p&gt;Moves the whole curve to lower or higher values, so that other tissue appears.&lt;/p&gt;&lt;p&gt;Up to a quarter of the volume&apos;s range either way, default 0. It springs back when let go; Shift drags finer.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Verschiebt die ganze Kurve zu kleineren oder größeren Werten, sodass anderes Gewebe erscheint.&lt;/p&gt;&lt;p&gt;Bis zu einem Viertel des Wertebereichs in beide Richtungen, Standard 0. Springt beim Loslassen zurück; mit Umschalt feiner.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Fine low opacities</source>
        <translation>Geringe Deckkraft fein</translation>
    </message>
    <message>
        <source>&lt;p&gt;Stretches the lower part of the opacity axis, where small changes show most in the picture; the curve itself stays.&lt;/p&gt;&lt;p&gt;On or off, default off.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Streckt den unteren Teil der Deckkraftachse, wo sich kleine Änderungen im Bild am stärksten zeigen; die Kurve selbst bleibt.&lt;/p&gt;&lt;p&gt;An oder aus, Standard aus.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Show all values of the volume (also: double click on the axis)</source>
        <translation>Zeigt alle Werte des Volumens (auch: Doppelklick auf die Achse)</translation>
    </message>
    <message>
        <source>Show all values</source>
        <translation>Alle Werte zeigen</translation>
    </message>
    <message>
        <source>change overall opacity %1</source>
        <translation>Gesamtdeckkraft ändern: %1</translation>
    </message>
    <message>
        <source>shift curve by %1</source>
        <translation>Kurve um %1 verschieben</translation>
    </message>
    <message>
        <source>Tools that find no room here.</source>
        <translation>Werkzeuge, die hier keinen Platz finden.</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>Weitere Werkzeuge</translation>
    </message>
    <message>
        <source>&lt;p&gt;Makes everything visible more solid or more transparent; what is invisible stays so.&lt;/p&gt;&lt;p&gt;×0.1 – ×10 of what it is, which is told until the curve changes otherwise. The slider springs back when let go, so that it can be pulled on; Shift drags finer.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Macht alles Sichtbare fester oder durchsichtiger; was unsichtbar ist, bleibt es.&lt;/p&gt;&lt;p&gt;×0,1 – ×10 dessen, was es ist; das steht da, bis sich die Kurve anders ändert. Der Regler springt beim Loslassen zurück, sodass man weiterziehen kann; mit Umschalt feiner.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>limn::TurnedBoxController</name>
    <message>
        <source>Turn the crop bo&amp;x to this view</source>
        <translation>Zuschnittbo&amp;x in diese Ansicht drehen</translation>
    </message>
    <message>
        <source>Puts a box over the picture that lies as the picture is seen now; what its faces, which are dragged, leave outside is cut away.</source>
        <translation>Legt eine Box über das Bild, die so liegt, wie es jetzt zu sehen ist; was ihre Flächen, die Sie ziehen, außen lassen, wird weggeschnitten.</translation>
    </message>
    <message>
        <source>The box lies as the picture does now. Its handles cut; the list of cuts has what they take.</source>
        <translation>Die Box liegt nun wie das Bild. Ihre Griffe schneiden; was sie wegnehmen, steht in der Liste der Schnitte.</translation>
    </message>
    <message>
        <source>Turned box, front and back</source>
        <translation>Gedrehte Box, vorn und hinten</translation>
    </message>
    <message>
        <source>Turned box, four sides</source>
        <translation>Gedrehte Box, vier Seiten</translation>
    </message>
    <message>
        <source>The crop box is put away; what its faces cut away stays so.</source>
        <translation>Die Zuschnittbox ist ausgeblendet; was ihre Seiten wegschneiden, bleibt weg.</translation>
    </message>
    <message>
        <source>Close the box&apos;s cuts</source>
        <translation>Schnitte der Box schließen</translation>
    </message>
    <message>
        <source>close the box&apos;s cuts</source>
        <translation>Schnitte der Box schließen</translation>
    </message>
</context>
<context>
    <name>limn::TurntableDialog</name>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern…</translation>
    </message>
    <message>
        <source>Save a turntable</source>
        <translation>Drehansicht speichern</translation>
    </message>
    <message>
        <source>Frames in a folder (PNG)</source>
        <translation>Einzelbilder in einem Ordner (PNG)</translation>
    </message>
    <message>
        <source>Video (MP4)</source>
        <translation>Video (MP4)</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>Breite in Pixeln</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>Höhe in Pixeln</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Save &amp;as</source>
        <translation>Speichern &amp;als</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Frames per s&amp;econd</source>
        <translation>Einzelbilder je Se&amp;kunde</translation>
    </message>
    <message>
        <source>A video can be made once the program ffmpeg is installed.</source>
        <translation>Ein Video kann erstellt werden, sobald das Programm ffmpeg installiert ist.</translation>
    </message>
    <message>
        <source>Drawing the turntable</source>
        <translation>Drehansicht wird gezeichnet</translation>
    </message>
    <message>
        <source>Drawing frame %1 of %2…</source>
        <translation>Einzelbild %1 von %2 wird gezeichnet…</translation>
    </message>
    <message>
        <source>&amp;Picture</source>
        <translation>&amp;Bild</translation>
    </message>
    <message>
        <source>Save &amp;turntable…</source>
        <translation>D&amp;rehansicht speichern…</translation>
    </message>
    <message>
        <source>Saves the picture from all around, as frames or a video.</source>
        <translation>Speichert das Bild rundum, als Einzelbilder oder Video.</translation>
    </message>
    <message>
        <source>Left: %1</source>
        <translation>Links: %1</translation>
    </message>
    <message>
        <source>Right: %1</source>
        <translation>Rechts: %1</translation>
    </message>
    <message>
        <source>Save the video</source>
        <translation>Video speichern</translation>
    </message>
    <message>
        <source>Save the frames in a new folder</source>
        <translation>Einzelbilder in neuem Ordner speichern</translation>
    </message>
    <message>
        <source>Video (*.mp4)</source>
        <translation>Video (*.mp4)</translation>
    </message>
    <message>
        <source>Folder of frames (*.frames)</source>
        <translation>Ordner mit Einzelbildern (*.frames)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 wurde gespeichert.</translation>
    </message>
    <message>
        <source>&amp;Begins at</source>
        <translation>Be&amp;ginnt bei</translation>
    </message>
    <message>
        <source>What the picture shows</source>
        <translation>Was das Bild zeigt</translation>
    </message>
    <message>
        <source>&amp;Letters, scale and &quot;Not for diagnosis&quot;</source>
        <translation>Buc&amp;hstaben, Maßstab und „Nicht zur Diagnose“</translation>
    </message>
    <message>
        <source>Angle of the turn</source>
        <translation>Winkel der Drehung</translation>
    </message>
    <message>
        <source>Whole turn</source>
        <translation>Ganze Umdrehung</translation>
    </message>
    <message>
        <source>Half turn</source>
        <translation>Halbe Umdrehung</translation>
    </message>
    <message>
        <source>Another angle</source>
        <translation>Anderer Winkel</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>&amp;Drehung</translation>
    </message>
    <message>
        <source>&amp;Frames</source>
        <translation>&amp;Einzelbilder</translation>
    </message>
    <message>
        <source>%1° about the patient&apos;s upright axis: a frame each %2°, %3 s.</source>
        <translation>%1° um die Längsachse des Patienten: ein Einzelbild je %2°, %3&#xa0;s.</translation>
    </message>
    <message>
        <source>A video has even sides: %1 × %2 pixels.</source>
        <translation>Ein Video hat gerade Seiten: %1 × %2 Pixel.</translation>
    </message>
    <message>
        <source>It begins at %1 % of the size on screen, so that nothing is cut off while it turns.</source>
        <translation>Sie beginnt mit %1&#xa0;% der Größe auf dem Schirm, damit beim Drehen nichts abgeschnitten wird.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Cancelled; no video was saved.</source>
        <translation>Abgebrochen; kein Video wurde gespeichert.</translation>
    </message>
    <message>
        <source>Cancelled; frames that were drawn stay in their folder.</source>
        <translation>Abgebrochen; gezeichnete Einzelbilder bleiben in ihrem Ordner.</translation>
    </message>
    <message>
        <source>Its frames do not say what they show: %1.</source>
        <translation>Seine Einzelbilder sagen nicht, was sie zeigen: %1.</translation>
    </message>
    <message>
        <source>What was measured is not in its frames.</source>
        <translation>Was gemessen wurde, ist in seinen Einzelbildern nicht zu sehen.</translation>
    </message>
</context>
<context>
    <name>limn::ViewInput</name>
    <message>
        <source>reset crop face: %1</source>
        <translation>Zuschnittfläche zurücksetzen: %1</translation>
    </message>
    <message>
        <source>reset crop</source>
        <translation>Zuschnitt zurücksetzen</translation>
    </message>
    <message>
        <source>turned box: reset %1 face</source>
        <translation>Fläche der gedrehten Box zurücksetzen: %1</translation>
    </message>
</context>
<context>
    <name>limn::ViewsController</name>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>&amp;Keep this view…</source>
        <translation>Diese Ansicht &amp;merken…</translation>
    </message>
    <message>
        <source>Keeps from where the picture is seen, under a name. Sessions and scenes keep it.</source>
        <translation>Merkt sich unter einem Namen, von wo das Bild gesehen wird. Sitzungen und Szenen behalten ihn.</translation>
    </message>
    <message>
        <source>Re&amp;name or delete views…</source>
        <translation>Ansichten um&amp;benennen oder löschen…</translation>
    </message>
    <message>
        <source>Lists the views that were kept of this volume.</source>
        <translation>Listet die Ansichten, die zu diesem Volumen gemerkt wurden.</translation>
    </message>
    <message>
        <source>Keep this view</source>
        <translation>Diese Ansicht merken</translation>
    </message>
    <message>
        <source>Name (a view of the same name is replaced):</source>
        <translation>Name (eine Ansicht gleichen Namens wird ersetzt):</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Merken</translation>
    </message>
    <message>
        <source>keep view &quot;%1&quot;</source>
        <translation>Ansicht „%1“ merken</translation>
    </message>
    <message>
        <source>Kept. View ▸ Look from has &quot;%1&quot;, Alt+1 … Alt+9 look from the first nine.</source>
        <translation>Gemerkt. „%1“ steht unter Ansicht ▸ Blick von; Alt+1 … Alt+9 rufen die ersten neun auf.</translation>
    </message>
</context>
<context>
    <name>limn::ViewsDialog</name>
    <message>
        <source>&amp;Look from there</source>
        <translation>Von dort &amp;blicken</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Kept views</source>
        <translation>Gemerkte Ansichten</translation>
    </message>
    <message>
        <source>Enter or a double click does the same.</source>
        <translation>Eingabe oder ein Doppelklick tut dasselbe.</translation>
    </message>
    <message>
        <source>F2 does the same.</source>
        <translation>F2 tut dasselbe.</translation>
    </message>
    <message>
        <source>Delete does the same; undo brings it back.</source>
        <translation>Entf tut dasselbe; Rückgängig bringt sie zurück.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>No view is kept. &quot;Keep this view…&quot; keeps the one of the picture.</source>
        <translation>Keine Ansicht ist gemerkt. „Diese Ansicht merken…“ merkt sich die des Bildes.</translation>
    </message>
    <message>
        <source>A view needs a name.</source>
        <translation>Eine Ansicht braucht einen Namen.</translation>
    </message>
    <message>
        <source>Another view has that name; choose one of its own.</source>
        <translation>Eine andere Ansicht heißt schon so; wählen Sie einen eigenen Namen.</translation>
    </message>
    <message>
        <source>rename view &quot;%1&quot;</source>
        <translation>Ansicht „%1“ umbenennen</translation>
    </message>
    <message>
        <source>delete view &quot;%1&quot;</source>
        <translation>Ansicht „%1“ löschen</translation>
    </message>
</context>
<context>
    <name>limn::WishSection</name>
    <message>
        <source>Chosen: %1</source>
        <translation>Gewählt: %1</translation>
    </message>
    <message>
        <source>Nothing is measured yet.</source>
        <translation>Noch ist nichts gemessen.</translation>
    </message>
    <message>
        <source>No measured picture is that close. Closest: %1</source>
        <translation>Kein gemessenes Bild ist so genau. Am nächsten: %1</translation>
    </message>
    <message>
        <source>No measured picture is that fast. Fastest: %1</source>
        <translation>Kein gemessenes Bild ist so schnell. Am schnellsten: %1</translation>
    </message>
    <message>
        <source>Error at most, levels</source>
        <translation>Fehler höchstens, Stufen</translation>
    </message>
    <message>
        <source>&lt;p&gt;Takes the fastest measured picture of which 999 in 1000 colour values are at most so many levels of 255 off.&lt;/p&gt;&lt;p&gt;Range 0.01 – 100, default 1.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Nimmt das schnellste gemessene Bild, bei dem 999 von 1000 Farbwerten höchstens so viele von 255 Stufen falsch sind.&lt;/p&gt;&lt;p&gt;Bereich 0,01 – 100, Standard 1.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Time at most, ms</source>
        <translation>Zeit höchstens, ms</translation>
    </message>
    <message>
        <source>&lt;p&gt;Takes the most exact measured picture that is drawn in at most so many milliseconds, at the size at which it was measured.&lt;/p&gt;&lt;p&gt;Range 1 – 100000, default 33.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Nimmt das genaueste gemessene Bild, das bei der gemessenen Größe in höchstens so vielen Millisekunden gezeichnet wird.&lt;/p&gt;&lt;p&gt;Bereich 1 – 100000, Standard 33.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>Use: %1</source>
        <translation>Verwenden: %1</translation>
    </message>
    <message>
        <source>The exact picture has not converged, so no error is known. A limit of time can be kept.</source>
        <translation>Das exakte Bild ist nicht konvergiert, deshalb ist kein Fehler bekannt. Eine Zeitgrenze lässt sich einhalten.</translation>
    </message>
    <message>
        <source>Choose by limit</source>
        <translation>Nach Grenzwert wählen</translation>
    </message>
    <message>
        <source>Measures this picture first: the choice is among what was measured.</source>
        <translation>Misst dieses Bild zuerst: Gewählt wird unter dem, was gemessen wurde.</translation>
    </message>
    <message>
        <source>Open a volume, or wait until the measuring is done.</source>
        <translation>Öffnen Sie ein Volumen, oder warten Sie, bis die Messung fertig ist.</translation>
    </message>
    <message>
        <source>By the law of chance: %1 paths a pixel, %2 s, within %3 levels. The picture goes on by itself while nothing moves.</source>
        <translation>Nach dem Gesetz des Zufalls: %1 Pfade je Bildpunkt, %2&#xa0;s, innerhalb von %3 Stufen. Das Bild geht von selbst weiter, solange sich nichts bewegt.</translation>
    </message>
</context>
<context>
    <name>limn::WorkRow</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel: %1</source>
        <translation>Abbrechen: %1</translation>
    </message>
</context>
</TS>
