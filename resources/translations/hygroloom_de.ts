<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>%1 cannot be put into %2: %3</source>
        <translation>%1 lässt sich nicht in %2 ablegen: %3</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>der Ordner lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>Runs cannot be recorded in %1: %2.</source>
        <translation>In %1 lassen sich keine Läufe aufzeichnen: %2.</translation>
    </message>
    <message>
        <source>%1 cannot be deleted: %2.</source>
        <translation>%1 lässt sich nicht löschen: %2.</translation>
    </message>
    <message>
        <source>%1: A report is a .pdf, .html, .txt or .json file. Give a name with one of these endings.</source>
        <translation>%1: Ein Bericht ist eine .pdf-, .html-, .txt- oder .json-Datei. Geben Sie einen Namen mit einer dieser Endungen an.</translation>
    </message>
    <message>
        <source>Save Report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>PDF</source>
        <translation>PDF</translation>
    </message>
    <message>
        <source>Web page</source>
        <translation>Webseite</translation>
    </message>
</context>
<context>
    <name>StudyData</name>
    <message>
        <source>fabric</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>experiment</source>
        <translation>Versuch</translation>
    </message>
</context>
<context>
    <name>StudyFields</name>
    <message>
        <source>Fidelity</source>
        <translation>Genauigkeit</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>wetted radius</source>
        <translation>Benetzungsradius</translation>
    </message>
    <message>
        <source>wetted radius in 5 mm rings</source>
        <translation>Benetzungsradius in Ringen von 5 mm</translation>
    </message>
    <message>
        <source>stain at rest from</source>
        <translation>Fleck in Ruhe ab</translation>
    </message>
    <message>
        <source>water between the yarns</source>
        <translation>Wasser zwischen den Garnen</translation>
    </message>
    <message>
        <source>water shed below</source>
        <translation>unten abgegebenes Wasser</translation>
    </message>
    <message>
        <source>absorbency time</source>
        <translation>Aufnahmezeit</translation>
    </message>
    <message>
        <source>wicking rate</source>
        <translation>Saugrate</translation>
    </message>
    <message>
        <source>wetting time</source>
        <translation>Benetzungszeit</translation>
    </message>
    <message>
        <source>absorption rate</source>
        <translation>Aufnahmerate</translation>
    </message>
    <message>
        <source>one-way transport</source>
        <translation>Einwegtransport</translation>
    </message>
    <message>
        <source>overall capability (OMMC)</source>
        <translation>Feuchtemanagement gesamt (OMMC)</translation>
    </message>
    <message>
        <source>class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Steighöhe</translation>
    </message>
    <message>
        <source>steady drying rate</source>
        <translation>gleichbleibende Trocknungsrate</translation>
    </message>
    <message>
        <source>time to dry</source>
        <translation>Trocknungszeit</translation>
    </message>
    <message>
        <source>steady temperature</source>
        <translation>gleichbleibende Temperatur</translation>
    </message>
    <message>
        <source>regain at the start</source>
        <translation>Feuchteaufnahme am Anfang</translation>
    </message>
    <message>
        <source>regain at the end</source>
        <translation>Feuchteaufnahme am Ende</translation>
    </message>
    <message>
        <source>half-change time</source>
        <translation>Halbwertszeit</translation>
    </message>
    <message>
        <source>peak warming above air</source>
        <translation>größte Erwärmung über die Luft</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>no 10 s without growth before the end</source>
        <translation>keine 10 s ohne Wachstum vor dem Ende</translation>
    </message>
    <message>
        <source>some of the liquid dripped off instead of being absorbed</source>
        <translation>ein Teil der Flüssigkeit tropfte ab, statt aufgenommen zu werden</translation>
    </message>
    <message>
        <source>nothing is wet</source>
        <translation>nichts ist nass</translation>
    </message>
    <message>
        <source>this face stayed dry</source>
        <translation>diese Seite blieb trocken</translation>
    </message>
    <message>
        <source>the liquid did not rise</source>
        <translation>die Flüssigkeit stieg nicht</translation>
    </message>
    <message>
        <source>less than 70 % of the water has dried</source>
        <translation>weniger als 70 % des Wassers sind getrocknet</translation>
    </message>
    <message>
        <source>more than 4 % of the water is left</source>
        <translation>mehr als 4 % des Wassers sind noch da</translation>
    </message>
    <message>
        <source>still changing</source>
        <translation>ändert sich noch</translation>
    </message>
    <message>
        <source>the regain did not change</source>
        <translation>die Feuchteaufnahme änderte sich nicht</translation>
    </message>
    <message>
        <source>the computed value is not a finite number</source>
        <translation>der berechnete Wert ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>water-proof or water-repellent</source>
        <translation>wasserdicht oder wasserabweisend</translation>
    </message>
    <message>
        <source>moisture management</source>
        <translation>Feuchtetransport</translation>
    </message>
    <message>
        <source>water penetration</source>
        <translation>Wasserdurchtritt</translation>
    </message>
    <message>
        <source>slow-absorbing and slow-drying</source>
        <translation>langsam saugend und langsam trocknend</translation>
    </message>
    <message>
        <source>fast-absorbing and quick-drying</source>
        <translation>schnell saugend und schnell trocknend</translation>
    </message>
    <message>
        <source>fast-absorbing and slow-drying</source>
        <translation>schnell saugend und langsam trocknend</translation>
    </message>
    <message>
        <source>water delivered</source>
        <translation>zugeführtes Wasser</translation>
    </message>
    <message>
        <source>free water</source>
        <translation>freies Wasser</translation>
    </message>
    <message>
        <source>water in the pores</source>
        <translation>Wasser in den Poren</translation>
    </message>
    <message>
        <source>water absorbed by the fibres</source>
        <translation>von den Fasern aufgenommenes Wasser</translation>
    </message>
    <message>
        <source>water taken from the air</source>
        <translation>aus der Luft aufgenommenes Wasser</translation>
    </message>
    <message>
        <source>water evaporated</source>
        <translation>verdunstetes Wasser</translation>
    </message>
    <message>
        <source>water dripped off</source>
        <translation>abgetropftes Wasser</translation>
    </message>
    <message>
        <source>water imbalance</source>
        <translation>Fehler der Wasserbilanz</translation>
    </message>
    <message>
        <source>energy released</source>
        <translation>freigesetzte Energie</translation>
    </message>
    <message>
        <source>energy imbalance</source>
        <translation>Fehler der Energiebilanz</translation>
    </message>
    <message>
        <source>Wetted radius</source>
        <translation>Benetzungsradius</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Steighöhe</translation>
    </message>
    <message>
        <source>Water content</source>
        <translation>Wassergehalt</translation>
    </message>
    <message>
        <source>% of dry mass</source>
        <translation>% der Trockenmasse</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>in yarns</source>
        <translation>in Garnen</translation>
    </message>
    <message>
        <source>in fibres</source>
        <translation>in Fasern</translation>
    </message>
    <message>
        <source>evaporated</source>
        <translation>verdunstet</translation>
    </message>
    <message>
        <source>dripped off</source>
        <translation>abgetropft</translation>
    </message>
    <message>
        <source>Water in the faces</source>
        <translation>Wasser in den Seiten</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>coldest yarn</source>
        <translation>kältestes Garn</translation>
    </message>
    <message>
        <source>warmest yarn</source>
        <translation>wärmstes Garn</translation>
    </message>
    <message>
        <source>Regain</source>
        <translation>Feuchteaufnahme</translation>
    </message>
    <message>
        <source>fibres</source>
        <translation>Fasern</translation>
    </message>
    <message>
        <source>the wetted radius, top</source>
        <translation>des Benetzungsradius, oben</translation>
    </message>
    <message>
        <source>the wetted radius, bottom</source>
        <translation>des Benetzungsradius, unten</translation>
    </message>
    <message>
        <source>the height</source>
        <translation>der Steighöhe</translation>
    </message>
    <message>
        <source>absorbs, baseline does not</source>
        <translation>nimmt auf, Bezug nicht</translation>
    </message>
    <message>
        <source>does not absorb, baseline does</source>
        <translation>nimmt nicht auf, Bezug schon</translation>
    </message>
    <message>
        <source>only this has it</source>
        <translation>nur dieses hat den Wert</translation>
    </message>
    <message>
        <source>only baseline has it</source>
        <translation>nur der Bezug hat den Wert</translation>
    </message>
    <message>
        <source>together</source>
        <translation>zusammen</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Droplets</source>
        <translation>Tropfen</translation>
    </message>
    <message>
        <source>Moisture management</source>
        <translation>Feuchtetransport</translation>
    </message>
    <message>
        <source>Vertical wicking</source>
        <translation>Vertikales Saugen</translation>
    </message>
    <message>
        <source>Horizontal wicking</source>
        <translation>Horizontales Saugen</translation>
    </message>
    <message>
        <source>Drying</source>
        <translation>Trocknung</translation>
    </message>
    <message>
        <source>Conditioning</source>
        <translation>Klimatisieren</translation>
    </message>
    <message>
        <source>Sweat</source>
        <translation>Schweiß</translation>
    </message>
    <message>
        <source>vertical wicking</source>
        <translation>Vertikales Saugen</translation>
    </message>
    <message>
        <source>horizontal wicking</source>
        <translation>Horizontales Saugen</translation>
    </message>
    <message>
        <source>drying</source>
        <translation>Trocknung</translation>
    </message>
    <message>
        <source>conditioning</source>
        <translation>Klimatisieren</translation>
    </message>
    <message>
        <source>sweat</source>
        <translation>Schweiß</translation>
    </message>
    <message>
        <source>liquid</source>
        <translation>Flüssigkeit</translation>
    </message>
    <message>
        <source>wicking</source>
        <translation>Dochtwirkung</translation>
    </message>
    <message>
        <source>sorption</source>
        <translation>Sorption</translation>
    </message>
    <message>
        <source>vapour</source>
        <translation>Dampf</translation>
    </message>
    <message>
        <source>heat</source>
        <translation>Wärme</translation>
    </message>
    <message>
        <source>growth</source>
        <translation>Wachstum</translation>
    </message>
    <message>
        <source>Plain, baskets and ribs</source>
        <translation>Leinwand, Panama und Rips</translation>
    </message>
    <message>
        <source>Twills</source>
        <translation>Köper</translation>
    </message>
    <message>
        <source>Broken and pointed twills</source>
        <translation>Kreuz- und Spitzköper</translation>
    </message>
    <message>
        <source>Satins</source>
        <translation>Kettatlas</translation>
    </message>
    <message>
        <source>Sateens</source>
        <translation>Schussatlas</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Effektbindungen</translation>
    </message>
    <message>
        <source>Bast fibres</source>
        <translation>Bastfasern</translation>
    </message>
    <message>
        <source>Cotton</source>
        <translation>Baumwolle</translation>
    </message>
    <message>
        <source>Filament</source>
        <translation>Filament</translation>
    </message>
    <message>
        <source>From the paper</source>
        <translation>Aus dem Aufsatz</translation>
    </message>
    <message>
        <source>Viscose</source>
        <translation>Viskose</translation>
    </message>
    <message>
        <source>Wool</source>
        <translation>Wolle</translation>
    </message>
    <message>
        <source>greige</source>
        <translation>rohweiß</translation>
    </message>
    <message>
        <source>scoured and bleached</source>
        <translation>abgekocht und gebleicht</translation>
    </message>
    <message>
        <source>mercerised</source>
        <translation>merzerisiert</translation>
    </message>
    <message>
        <source>hydrophilic softener</source>
        <translation>hydrophiler Weichmacher</translation>
    </message>
    <message>
        <source>wicking finish on polyester</source>
        <translation>Saugausrüstung auf Polyester</translation>
    </message>
    <message>
        <source>bare polyester</source>
        <translation>Polyester ohne Ausrüstung</translation>
    </message>
    <message>
        <source>durable water repellent</source>
        <translation>dauerhaft wasserabweisend</translation>
    </message>
    <message>
        <source>cotton</source>
        <translation>Baumwolle</translation>
    </message>
    <message>
        <source>wool</source>
        <translation>Wolle</translation>
    </message>
    <message>
        <source>polyester</source>
        <translation>Polyester</translation>
    </message>
    <message>
        <source>hemp</source>
        <translation>Hanf</translation>
    </message>
    <message>
        <source>flax</source>
        <translation>Flachs</translation>
    </message>
    <message>
        <source>silk</source>
        <translation>Seide</translation>
    </message>
    <message>
        <source>viscose</source>
        <translation>Viskose</translation>
    </message>
    <message>
        <source>nylon 6.6</source>
        <translation>Nylon 6.6</translation>
    </message>
    <message>
        <source>acrylic</source>
        <translation>Polyacryl</translation>
    </message>
    <message>
        <source>lyocell</source>
        <translation>Lyocell</translation>
    </message>
    <message>
        <source>modal</source>
        <translation>Modal</translation>
    </message>
    <message>
        <source>polypropylene</source>
        <translation>Polypropylen</translation>
    </message>
    <message>
        <source>elastane</source>
        <translation>Elasthan</translation>
    </message>
    <message>
        <source>water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>saline</source>
        <translation>Kochsalzlösung</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>abdomen</source>
        <translation>Bauch</translation>
    </message>
    <message>
        <source>back</source>
        <translation>Rücken</translation>
    </message>
    <message>
        <source>buttocks</source>
        <translation>Gesäß</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>Oberarm</translation>
    </message>
    <message>
        <source>forearm</source>
        <translation>Unterarm</translation>
    </message>
    <message>
        <source>palm</source>
        <translation>Handfläche</translation>
    </message>
    <message>
        <source>back of hand</source>
        <translation>Handrücken</translation>
    </message>
    <message>
        <source>thigh</source>
        <translation>Oberschenkel</translation>
    </message>
    <message>
        <source>shin</source>
        <translation>Schienbein</translation>
    </message>
    <message>
        <source>sole</source>
        <translation>Fußsohle</translation>
    </message>
    <message>
        <source>top of foot</source>
        <translation>Fußrücken</translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation>Schulter</translation>
    </message>
    <message>
        <source>taylor-2013 rest</source>
        <translation>Taylor 2013, Ruhe</translation>
    </message>
    <message>
        <source>taylor-2013 exercise</source>
        <translation>Taylor 2013, Belastung</translation>
    </message>
    <message>
        <source>tee</source>
        <translation>T-Shirt</translation>
    </message>
    <message>
        <source>singlet</source>
        <translation>Trägerhemd</translation>
    </message>
    <message>
        <source>leggings</source>
        <translation>Leggings</translation>
    </message>
    <message>
        <source>warp</source>
        <translation>Kette</translation>
    </message>
    <message>
        <source>weft</source>
        <translation>Schuss</translation>
    </message>
    <message>
        <source>extra yarns</source>
        <translation>weitere Garne</translation>
    </message>
    <message>
        <source>climate</source>
        <translation>Klima</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>droplets</source>
        <translation>Tropfen</translation>
    </message>
    <message>
        <source>at</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>contact angle</source>
        <translation>Randwinkel</translation>
    </message>
    <message>
        <source>crimp</source>
        <translation>Einwebung</translation>
    </message>
    <message>
        <source>density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>ends</source>
        <translation>Kettfäden</translation>
    </message>
    <message>
        <source>fibre diffusivity</source>
        <translation>Diffusivität der Faser</translation>
    </message>
    <message>
        <source>flyaway</source>
        <translation>abstehende Fasern</translation>
    </message>
    <message>
        <source>isotherm</source>
        <translation>Isotherme</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>picks</source>
        <translation>Schussfäden</translation>
    </message>
    <message>
        <source>sorption heat</source>
        <translation>Sorptionswärme</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>swelling</source>
        <translation>Quellung</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>initial</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>particles per droplet</source>
        <translation>Partikel je Tropfen</translation>
    </message>
    <message>
        <source>fibre shells</source>
        <translation>Schalen je Faser</translation>
    </message>
    <message>
        <source>crossings per cell</source>
        <translation>Kreuzungspunkte je Zelle</translation>
    </message>
    <message>
        <source>crossings per even cell</source>
        <translation>Kreuzungspunkte je gleichmäßiger Zelle</translation>
    </message>
    <message>
        <source>network step limit s</source>
        <translation>längster Zeitschritt der Garne</translation>
    </message>
    <message>
        <source>saturation change</source>
        <translation>Änderung der Sättigung</translation>
    </message>
    <message>
        <source>step error</source>
        <translation>Schrittfehler</translation>
    </message>
    <message>
        <source>liquid step factor</source>
        <translation>Schrittfaktor der Flüssigkeit</translation>
    </message>
    <message>
        <source>steps between absorption</source>
        <translation>Schritte zwischen Aufnahmen</translation>
    </message>
    <message>
        <source>density tolerance</source>
        <translation>Dichtetoleranz</translation>
    </message>
    <message>
        <source>settle share</source>
        <translation>Ruheanteil</translation>
    </message>
    <message>
        <source>rest tolerance</source>
        <translation>Ruhetoleranz</translation>
    </message>
    <message>
        <source>double precision</source>
        <translation>doppelte Genauigkeit</translation>
    </message>
    <message>
        <source>free liquid</source>
        <translation>freie Flüssigkeit</translation>
    </message>
    <message>
        <source>neglected share</source>
        <translation>vernachlässigter Anteil</translation>
    </message>
    <message>
        <source>room voxels</source>
        <translation>Voxel des Raums zwischen Garnen</translation>
    </message>
    <message>
        <source>live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>warp fibre</source>
        <translation>Faser der Kette</translation>
    </message>
    <message>
        <source>weft fibre</source>
        <translation>Faser des Schusses</translation>
    </message>
    <message>
        <source>warp count</source>
        <translation>Feinheit der Kette</translation>
    </message>
    <message>
        <source>weft count</source>
        <translation>Feinheit des Schusses</translation>
    </message>
    <message>
        <source>warp construction</source>
        <translation>Aufbau der Kette</translation>
    </message>
    <message>
        <source>weft construction</source>
        <translation>Aufbau des Schusses</translation>
    </message>
    <message>
        <source>weave</source>
        <translation>Bindung</translation>
    </message>
    <message>
        <source>warp sett</source>
        <translation>Kettdichte</translation>
    </message>
    <message>
        <source>weft sett</source>
        <translation>Schussdichte</translation>
    </message>
    <message>
        <source>stripes</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>hairs and loops</source>
        <translation>Faserenden und Schlingen</translation>
    </message>
    <message>
        <source>finish of the upper face</source>
        <translation>Ausrüstung der Oberseite</translation>
    </message>
    <message>
        <source>finish of the lower face</source>
        <translation>Ausrüstung der Unterseite</translation>
    </message>
    <message>
        <source>measured values</source>
        <translation>gemessene Werte</translation>
    </message>
    <message>
        <source>spreading speed by 5 mm rings</source>
        <translation>Ausbreitungsgeschwindigkeit nach 5-mm-Ringen</translation>
    </message>
    <message>
        <source>core</source>
        <translation>Kern</translation>
    </message>
    <message>
        <source>cap</source>
        <translation>Kappe</translation>
    </message>
    <message>
        <source>ellipse of equal moments on top, semi-axis along warp</source>
        <translation>Ellipse gleicher Momente oben, Halbachse in Kettrichtung</translation>
    </message>
    <message>
        <source>ellipse of equal moments on top, semi-axis along weft</source>
        <translation>Ellipse gleicher Momente oben, Halbachse in Schussrichtung</translation>
    </message>
    <message>
        <source>round</source>
        <translation>rund</translation>
    </message>
    <message>
        <source>trilobal</source>
        <translation>trilobal</translation>
    </message>
    <message>
        <source>bean</source>
        <translation>bohnenförmig</translation>
    </message>
    <message>
        <source>channelled</source>
        <translation>gerillt</translation>
    </message>
    <message>
        <source>only a part of the test is there</source>
        <translation>nur ein Teil der Prüfung liegt vor</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>sie ist nicht lesbar</translation>
    </message>
    <message>
        <source>it needs a unit</source>
        <translation>die Einheit fehlt</translation>
    </message>
    <message>
        <source>it names two units</source>
        <translation>sie nennt zwei Einheiten</translation>
    </message>
    <message>
        <source>it names the plies twice</source>
        <translation>sie nennt die Fachung zweimal</translation>
    </message>
    <message>
        <source>a yarn has 1 to 6 plies</source>
        <translation>ein Garn hat 1 bis 6 Fachungen</translation>
    </message>
    <message>
        <source>a yarn of filaments has 2 to 100000 of them</source>
        <translation>ein Filamentgarn hat 2 bis 100000 Filamente</translation>
    </message>
    <message>
        <source>a yarn has 0.05 to 50000 tex</source>
        <translation>ein Garn hat 0.05 bis 50000 tex</translation>
    </message>
    <message>
        <source>filaments go with den, dtex or tex</source>
        <translation>Filamente stehen bei den, dtex oder tex</translation>
    </message>
    <message>
        <source>a stroke after tex may mean plies or filaments; write × 2 or f2</source>
        <translation>ein Strich nach tex kann Fachung oder Filamente meinen; schreiben Sie × 2 oder f2</translation>
    </message>
    <message>
        <source>stain radius by area</source>
        <translation>Fleckradius nach Fläche</translation>
    </message>
    <message>
        <source>aspect of the stain on top</source>
        <translation>Längenverhältnis des Flecks oben</translation>
    </message>
    <message>
        <source>arms of the stain on top</source>
        <translation>Arme des Flecks oben</translation>
    </message>
    <message>
        <source>solidity of the stain on top</source>
        <translation>Geschlossenheit des Flecks oben</translation>
    </message>
    <message>
        <source>the stain is too small, or shown in cells</source>
        <translation>der Fleck ist zu klein oder in Zellen gezeigt</translation>
    </message>
    <message>
        <source>area of the stain</source>
        <translation>Fläche des Flecks</translation>
    </message>
    <message>
        <source>water at the start</source>
        <translation>Wasser am Anfang</translation>
    </message>
    <message>
        <source>liquid is left on the cloth, or falls through it</source>
        <translation>Flüssigkeit bleibt auf dem Stoff stehen oder fällt hindurch</translation>
    </message>
    <message>
        <source>Advancing contact angle of water on the finished fabric. Leave empty to use that of each yarn&apos;s fibres. Above 90° the yarns do not absorb water.</source>
        <translation>Fortschreitender Randwinkel von Wasser auf dem ausgerüsteten Gewebe. Leer lassen, um den der Fasern jedes Garns zu nehmen. Über 90° nehmen die Garne kein Wasser auf.</translation>
    </message>
    <message>
        <source>Air speed</source>
        <translation>Luftgeschwindigkeit</translation>
    </message>
    <message>
        <source>At 20 °C; at other temperatures it follows that of water.</source>
        <translation>Bei 20 °C; bei anderen Temperaturen folgt sie der von Wasser.</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Chest</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Coefficient of variation of the linear density along the yarn (Uster CVm). Leave empty for what is usual of such a yarn. Acts in the closure “pores” only.</source>
        <translation>Variationskoeffizient der Feinheit entlang des Garns (Uster CVm). Leer lassen für das, was bei einem solchen Garn üblich ist. Wirkt nur im Saugmodell mit Poren.</translation>
    </message>
    <message>
        <source>Conductivity</source>
        <translation>Leitfähigkeit</translation>
    </message>
    <message>
        <source>Contact angle</source>
        <translation>Randwinkel</translation>
    </message>
    <message>
        <source>Contact angle of a finish on this face alone. Leave empty for the yarns&apos; own. Acts in the closure “pores” only.</source>
        <translation>Randwinkel einer Ausrüstung nur auf dieser Seite. Leer lassen für den der Garne selbst. Wirkt nur im Saugmodell mit Poren.</translation>
    </message>
    <message>
        <source>Contact angle ±</source>
        <translation>Randwinkel ±</translation>
    </message>
    <message>
        <source>Core share</source>
        <translation>Kernanteil</translation>
    </message>
    <message>
        <source>Crimp</source>
        <translation>Einwebung</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Depth of the strip&apos;s end below the liquid surface.</source>
        <translation>Tiefe des Streifenendes unter der Flüssigkeitsoberfläche.</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Downward speed when it appears.</source>
        <translation>Geschwindigkeit abwärts, wenn er erscheint.</translation>
    </message>
    <message>
        <source>Drop volume</source>
        <translation>Tropfenvolumen</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Zugabe</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Kettfäden</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Feed time</source>
        <translation>Dauer der Zufuhr</translation>
    </message>
    <message>
        <source>Fibre ends that stand out of the yarn, per mm of yarn. With the closure “pores” they hold falling drops off dry yarns.</source>
        <translation>Faserenden, die vom Garn abstehen, je mm Garn. Im Saugmodell mit Poren halten sie fallende Tropfen von trockenen Garnen fern.</translation>
    </message>
    <message>
        <source>Fibre volume divided by yarn volume: 0.45 to 0.68 for spun yarns. Where it does not follow from the others, it is 0.5 of a given diameter, else that of the yarn&apos;s class.</source>
        <translation>Faservolumen durch Garnvolumen: 0.45 bis 0.68 bei gesponnenen Garnen. Wo sie nicht aus den anderen Werten folgt, ist sie bei gegebenem Durchmesser 0.5, sonst die der Garnklasse.</translation>
    </message>
    <message>
        <source>Fibres drawn</source>
        <translation>Gezeichnete Fasern</translation>
    </message>
    <message>
        <source>Fibres that leave the yarn and come back to it, per mm of yarn. With the closure “pores” they hold falling drops off dry yarns.</source>
        <translation>Fasern, die das Garn verlassen und zurückkehren, je mm Garn. Im Saugmodell mit Poren halten sie fallende Tropfen von trockenen Garnen fern.</translation>
    </message>
    <message>
        <source>Filaments</source>
        <translation>Filamente</translation>
    </message>
    <message>
        <source>Finish, back</source>
        <translation>Ausrüstung, Rückseite</translation>
    </message>
    <message>
        <source>Finish, depth</source>
        <translation>Ausrüstung, Tiefe</translation>
    </message>
    <message>
        <source>Finish, top face</source>
        <translation>Ausrüstung, Oberseite</translation>
    </message>
    <message>
        <source>Finish, untreated</source>
        <translation>Ausrüstung, Lücken</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>From dry to saturated, per gram of fibre. 0: what the law of sorption heats gives.</source>
        <translation>Von trocken bis gesättigt, je Gramm Faser. 0: was das Gesetz der Sorptionswärmen ergibt.</translation>
    </message>
    <message>
        <source>From the shoulder to the hem; of leggings from the waist to the ankle.</source>
        <translation>Von der Schulter bis zum Saum; bei Leggings von der Taille bis zum Knöchel.</translation>
    </message>
    <message>
        <source>Girth of the body&apos;s chest; of leggings of its hip.</source>
        <translation>Brustumfang des Körpers; bei Leggings sein Hüftumfang.</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Hair length</source>
        <translation>Länge der Enden</translation>
    </message>
    <message>
        <source>Hairs</source>
        <translation>Faserenden</translation>
    </message>
    <message>
        <source>Heat of wetting</source>
        <translation>Benetzungswärme</translation>
    </message>
    <message>
        <source>Height of its lowest point above the fabric.</source>
        <translation>Höhe seines tiefsten Punktes über dem Gewebe.</translation>
    </message>
    <message>
        <source>Height of the highest loop above the yarn; the lowest is half as high. Loops make the cloth thicker, and the still air among them slows drying.</source>
        <translation>Höhe der höchsten Schlinge über dem Garn; die niedrigste ist halb so hoch. Schlingen machen das Gewebe dicker, und die ruhende Luft in ihnen verlangsamt das Trocknen.</translation>
    </message>
    <message>
        <source>How deep the finish of a face reaches, of the fabric&apos;s thickness. The yarns wick below it. Leave empty for 10 %, which is assumed. 100 %: the yarns that lie on the face are finished through. Acts in the closure “pores” only.</source>
        <translation>Wie tief die Ausrüstung einer Seite reicht, als Anteil der Gewebedicke. Darunter saugen die Garne. Leer lassen für 10 %, eine Annahme. 100 %: Die Garne auf der Seite sind ganz ausgerüstet. Wirkt nur im Saugmodell mit Poren.</translation>
    </message>
    <message>
        <source>How much longer the garment&apos;s girth is than the body&apos;s.</source>
        <translation>Wie viel weiter das Kleidungsstück ist als der Körper.</translation>
    </message>
    <message>
        <source>How much longer the yarn is than the fabric. Leave empty to share the crimp between warp and weft by their spans. Without a thickness it gives way where yarns would be packed closer than 0.85.</source>
        <translation>Wie viel länger das Garn ist als der Stoff. Leer: Kette und Schuss teilen sich die Einarbeitung nach ihren Abständen. Ohne gegebene Dicke gibt sie nach, wo Garne sonst dichter als 0.85 gepackt wären.</translation>
    </message>
    <message>
        <source>How the yarn is made: packing, section and fibres that stand out follow from it where they are not given. Leave it out for what fibre, twist, plies and filaments make likely.</source>
        <translation>Wie das Garn hergestellt ist: Packung, Querschnitt und abstehende Fasern folgen daraus, wo sie nicht gegeben sind. Leer: wie Faser, Drehung, Fachung und Filamente es nahelegen.</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>Feuchte</translation>
    </message>
    <message>
        <source>Immersion</source>
        <translation>Eintauchtiefe</translation>
    </message>
    <message>
        <source>Initial water</source>
        <translation>Wasser am Anfang</translation>
    </message>
    <message>
        <source>Irregularity</source>
        <translation>Ungleichmäßigkeit</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Linear density</source>
        <translation>Feinheit</translation>
    </message>
    <message>
        <source>Liquid water in the fabric at the start, in addition to its regain in this climate.</source>
        <translation>Flüssiges Wasser im Gewebe am Anfang, zusätzlich zu seiner Feuchteaufnahme in diesem Klima.</translation>
    </message>
    <message>
        <source>Loop height</source>
        <translation>Schlingenhöhe</translation>
    </message>
    <message>
        <source>Loops</source>
        <translation>Schlingen</translation>
    </message>
    <message>
        <source>Mean length of the fibre ends; the shortest have half of it, the longest one and a half times.</source>
        <translation>Mittlere Länge der Faserenden; die kürzesten haben die Hälfte, die längsten das Anderthalbfache.</translation>
    </message>
    <message>
        <source>Measured. Replaces the calculated value. Leave empty to use the calculated one.</source>
        <translation>Gemessen. Tritt an die Stelle des berechneten Werts. Leer: der berechnete gilt.</translation>
    </message>
    <message>
        <source>Monolayer regain</source>
        <translation>Feuchte der Monolage</translation>
    </message>
    <message>
        <source>Of a circle of the fibre&apos;s area. A yarn&apos;s filament count takes its place.</source>
        <translation>Eines Kreises mit der Fläche der Faser. Die Filamentzahl eines Garns ersetzt ihn.</translation>
    </message>
    <message>
        <source>Of a tee, from the shoulder&apos;s point to the hem.</source>
        <translation>Bei einem T-Shirt vom Schulterpunkt bis zum Saum.</translation>
    </message>
    <message>
        <source>Of a yarn of continuous filaments, all plies together. Their radius, and the pores between them, follow from it and the linear density. Leave empty for staple yarns: the material&apos;s fibre radius counts.</source>
        <translation>Bei Garn aus Endlosfilamenten, alle Fäden zusammen. Ihr Radius und die Poren dazwischen folgen daraus und aus der Feinheit. Leer bei Stapelgarn: Dann zählt der Faserradius des Materials.</translation>
    </message>
    <message>
        <source>Of cloth that lie on each other, the last on the skin.</source>
        <translation>Stofflagen übereinander, die letzte auf der Haut.</translation>
    </message>
    <message>
        <source>Of heat, across the fibre.</source>
        <translation>Für Wärme, quer zur Faser.</translation>
    </message>
    <message>
        <source>Of the dry fibre.</source>
        <translation>Der trockenen Faser.</translation>
    </message>
    <message>
        <source>Of the free, round yarn. Typed here, it takes the place of the count.</source>
        <translation>Des freien, runden Garns. Hier eingegeben, tritt er an die Stelle der Feinheit.</translation>
    </message>
    <message>
        <source>Of the rates that the wearer&apos;s table of zones gives.</source>
        <translation>Mal die Raten aus der Zonentabelle des Trägers.</translation>
    </message>
    <message>
        <source>Of the single yarn.</source>
        <translation>Des einfachen Garns.</translation>
    </message>
    <message>
        <source>Of the strip&apos;s long side.</source>
        <translation>Der langen Seite des Streifens.</translation>
    </message>
    <message>
        <source>Of the warp, from the pattern&apos;s +y, counter-clockwise as seen from outside.</source>
        <translation>Der Kette, von +y des Schnitts aus, von außen gesehen gegen den Uhrzeigersinn.</translation>
    </message>
    <message>
        <source>Of the whole yarn, with all its plies.</source>
        <translation>Des ganzen Garns mit allen Fäden.</translation>
    </message>
    <message>
        <source>Of the yarn&apos;s mass.</source>
        <translation>Anteil an der Masse des Garns.</translation>
    </message>
    <message>
        <source>Of water that advances. A fabric&apos;s finish takes its place.</source>
        <translation>Von vorrückendem Wasser. Die Ausrüstung eines Gewebes ersetzt ihn.</translation>
    </message>
    <message>
        <source>Of water that draws back; at most the contact angle. Leave empty for the assumed one: 0 on cotton, flax, hemp and viscose, else 20° less than the contact angle. Acts in the closure “pores” only.</source>
        <translation>Von Wasser, das sich zurückzieht; höchstens der Randwinkel. Leer für den angenommenen: 0 auf Baumwolle, Flachs, Hanf und Viskose, sonst 20° weniger als der Randwinkel. Wirkt nur im Saugmodell mit Poren.</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Packungsdichte</translation>
    </message>
    <message>
        <source>Packing ±</source>
        <translation>Packung ±</translation>
    </message>
    <message>
        <source>Per yarn, in pictures and exports. Each represents a bundle of real fibres.</source>
        <translation>Je Garn, in Bildern und Exporten. Jede steht für ein Bündel wirklicher Fasern.</translation>
    </message>
    <message>
        <source>Picks</source>
        <translation>Schüsse</translation>
    </message>
    <message>
        <source>Plies</source>
        <translation>Fachung</translation>
    </message>
    <message>
        <source>Ply direction</source>
        <translation>Zwirnrichtung</translation>
    </message>
    <message>
        <source>Ply twist</source>
        <translation>Zwirndrehung</translation>
    </message>
    <message>
        <source>Porosity</source>
        <translation>Porosität</translation>
    </message>
    <message>
        <source>Receding angle</source>
        <translation>Rückzugswinkel</translation>
    </message>
    <message>
        <source>Receding angle ±</source>
        <translation>Rückzugswinkel ±</translation>
    </message>
    <message>
        <source>Relative humidity of the air, 1 where it is saturated. Over 1 vapour condenses on the cloth.</source>
        <translation>Relative Feuchte der Luft, 1 bei Sättigung. Über 1 kondensiert Dampf auf dem Stoff.</translation>
    </message>
    <message>
        <source>Saturation regain</source>
        <translation>Sättigungsfeuchte</translation>
    </message>
    <message>
        <source>Share of the crowns and hairs on the finished face that the finish leaves untreated: liquid passes there at once. Leave empty for none. Acts in the closure “pores” only.</source>
        <translation>Anteil der Bindungspunkte und Haare auf der ausgerüsteten Seite, den die Ausrüstung auslässt: Dort dringt Flüssigkeit sofort ein. Leer lassen für keine. Wirkt nur im Saugmodell mit Poren.</translation>
    </message>
    <message>
        <source>Single yarns twisted together. Diameter and linear density are those of the whole yarn.</source>
        <translation>Zusammengedrehte Einzelgarne. Durchmesser und Fadenfeinheit sind die des ganzen Garns.</translation>
    </message>
    <message>
        <source>Skin temperature</source>
        <translation>Hauttemperatur</translation>
    </message>
    <message>
        <source>Sleeve</source>
        <translation>Ärmel</translation>
    </message>
    <message>
        <source>Specific heat</source>
        <translation>Spezifische Wärme</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Standard regain</source>
        <translation>Normalfeuchte</translation>
    </message>
    <message>
        <source>Surface tension</source>
        <translation>Oberflächenspannung</translation>
    </message>
    <message>
        <source>Sweat rate</source>
        <translation>Schweißrate</translation>
    </message>
    <message>
        <source>That is fed; the skin is at the bottom.</source>
        <translation>Die gespeist wird; die Haut ist unten.</translation>
    </message>
    <message>
        <source>That the garment is wet with.</source>
        <translation>Mit dem das Kleidungsstück nass ist.</translation>
    </message>
    <message>
        <source>The feed comes in equal drops of at most this volume, each when the pump has delivered it. Drops join a pool that the cloth absorbs. 0: the feed flows evenly.</source>
        <translation>Die Zufuhr kommt in gleichen Tropfen von höchstens diesem Volumen, jeder, sobald die Pumpe ihn gefördert hat. Tropfen fließen in eine Lache, die das Gewebe aufnimmt. 0: Die Zufuhr fließt gleichmäßig.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Time at which the drop appears.</source>
        <translation>Zeit, zu der der Tropfen erscheint.</translation>
    </message>
    <message>
        <source>Time for which the pump runs.</source>
        <translation>Zeit, in der die Pumpe läuft.</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Mal</translation>
    </message>
    <message>
        <source>Times the activity&apos;s factor.</source>
        <translation>Mal den Faktor der Aktivität.</translation>
    </message>
    <message>
        <source>Tortuosity</source>
        <translation>Tortuosität</translation>
    </message>
    <message>
        <source>Turns of the plies round each other.</source>
        <translation>Drehungen der Einzelgarne umeinander.</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Twist direction</source>
        <translation>Drehrichtung</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viskosität</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Warp crimp</source>
        <translation>Einwebung der Kette</translation>
    </message>
    <message>
        <source>Warp yarns per centimetre. You can type “89 epi”.</source>
        <translation>Kettfäden je Zentimeter. Sie können „89 epi“ eingeben.</translation>
    </message>
    <message>
        <source>Water per dry fibre at 100 % relative humidity.</source>
        <translation>Wasser je trockener Faser bei 100 % relativer Feuchte.</translation>
    </message>
    <message>
        <source>Water per dry fibre at 65 % relative humidity and 20 °C, absorption.</source>
        <translation>Wasser je trockener Faser bei 65 % relativer Feuchte und 20 °C, Aufnahme.</translation>
    </message>
    <message>
        <source>Weft crimp</source>
        <translation>Einwebung des Schusses</translation>
    </message>
    <message>
        <source>Weft yarns per centimetre. You can type “89 ppi”.</source>
        <translation>Schussfäden je Zentimeter. Sie können „89 ppi“ eingeben.</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Flächengewicht</translation>
    </message>
    <message>
        <source>Whether the fabric&apos;s top face lies outside.</source>
        <translation>Ob die Oberseite des Stoffs außen liegt.</translation>
    </message>
    <message>
        <source>With the loops on both faces. Leave empty to calculate it from the yarns.</source>
        <translation>Mit den Schlingen auf beiden Seiten. Leer: Sie wird aus den Garnen berechnet.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source> and more</source>
        <translation> und weitere</translation>
    </message>
    <message>
        <source>; did you mean &quot;{}&quot;?</source>
        <translation>; meinten Sie „{}“?</translation>
    </message>
    <message>
        <source>A changing climate has at most {} times; given are {}.</source>
        <translation>Ein wechselndes Klima hat höchstens {} Zeiten; gegeben sind {}.</translation>
    </message>
    <message>
        <source>A drop of {:.3g} µl, {:.2g} wide, falls through &quot;{}&quot;: its holes are {:.2g} wide.</source>
        <translation>Ein Tropfen von {:.3g} µl, {:.2g} breit, fällt durch „{}“: Seine Löcher sind {:.2g} breit.</translation>
    </message>
    <message>
        <source>A fabric may have up to {} extra yarns; given are {}.</source>
        <translation>Ein Gewebe darf bis zu {} weitere Garne haben; gegeben sind {}.</translation>
    </message>
    <message>
        <source>A feed of {} ul may come in at most {} drops, of {} ul or more; given are drops of {} ul.</source>
        <translation>Eine Zufuhr von {} µl darf in höchstens {} Tropfen kommen, von {} µl oder mehr; gegeben sind Tropfen von {} µl.</translation>
    </message>
    <message>
        <source>A garment needs a fabric for its panels; name panels, or &quot;*&quot; for all that are not named.</source>
        <translation>Ein Kleidungsstück braucht ein Gewebe für seine Schnittteile; nennen Sie Schnittteile, oder „*“ für alle, die nicht genannt sind.</translation>
    </message>
    <message>
        <source>A monofilament is one filament, without filament_count and of one ply.</source>
        <translation>Ein Monofilament ist ein einziges Filament, ohne Filamentzahl und nicht gezwirnt.</translation>
    </message>
    <message>
        <source>A panel of 1 layer has no lining; give it 2 layers or more, or leave lining out.</source>
        <translation>Ein Schnittteil aus 1 Lage hat kein Futter; geben Sie ihm 2 Lagen oder mehr, oder lassen Sie das Futter weg.</translation>
    </message>
    <message>
        <source>A repeat may have up to {} ends and picks; given are {} and {}.</source>
        <translation>Ein Rapport darf bis zu {} Kett- und Schussfäden haben; gegeben sind {} und {}.</translation>
    </message>
    <message>
        <source>A sample of {:.4g} x {:.4g} is smaller than one crossing of &quot;{}&quot;; one crossing is taken.</source>
        <translation>Eine Probe von {:.4g} x {:.4g} ist kleiner als eine Kreuzung von „{}“; eine Kreuzung wird genommen.</translation>
    </message>
    <message>
        <source>A sample of {:.4g} x {:.4g} of &quot;{}&quot; has {:.3g} million crossings; at most {:.3g} million are allowed.</source>
        <translation>Eine Probe von {:.4g} x {:.4g} von „{}“ hat {:.3g} Millionen Kreuzungen; höchstens {:.3g} Millionen sind erlaubt.</translation>
    </message>
    <message>
        <source>A seam is named &quot;panel|panel&quot;, or &quot;default&quot; for all others; given is &quot;{}&quot;.</source>
        <translation>Eine Naht heißt „Schnittteil|Schnittteil“, oder „default“ für alle anderen; gegeben ist „{}“.</translation>
    </message>
    <message>
        <source>A share must be more than 0 and at most 1; given is {}.</source>
        <translation>Ein Anteil muss mehr als 0 und höchstens 1 sein; gegeben ist {}.</translation>
    </message>
    <message>
        <source>A thickness of {:.4g} less loops of {:.4g} on both faces leaves {:.3g} for yarns of {:.3g} and {:.3g}; a tenth of their sum is the least.</source>
        <translation>Eine Dicke von {:.4g} ohne die Schlingen von {:.4g} auf beiden Seiten lässt {:.3g} für Garne von {:.3g} und {:.3g}; mindestens ein Zehntel ihrer Summe ist nötig.</translation>
    </message>
    <message>
        <source>A two-stage diffusion law is known for cotton and wool, and for materials based on them; give a number in m2/s.</source>
        <translation>Ein zweistufiges Diffusionsgesetz ist für Baumwolle und Wolle bekannt und für Materialien, die auf ihnen beruhen; geben Sie eine Zahl in m²/s.</translation>
    </message>
    <message>
        <source>A wearer has at most {} own zones; given are {}.</source>
        <translation>Ein Träger hat höchstens {} eigene Zonen; gegeben sind {}.</translation>
    </message>
    <message>
        <source>A wearer&apos;s activity begins at 0 s; give its factor from there on.</source>
        <translation>Die Aktivität eines Trägers beginnt bei 0 s; geben Sie ihren Faktor von da an.</translation>
    </message>
    <message>
        <source>A wearer&apos;s activity may change {} times at most; given are {}.</source>
        <translation>Die Aktivität eines Trägers darf sich höchstens {}-mal ändern; gegeben sind {}.</translation>
    </message>
    <message>
        <source>Activities stand in order of time; given is {} s after {} s.</source>
        <translation>Aktivitäten stehen in zeitlicher Folge; gegeben ist {} s nach {} s.</translation>
    </message>
    <message>
        <source>All drops together may have up to {} g; given are {:.4g}.</source>
        <translation>Alle Tropfen zusammen dürfen bis zu {} g haben; gegeben sind {:.4g}.</translation>
    </message>
    <message>
        <source>At a contact angle of {:.3g} degrees water does not wick into the yarns; it wicks below 90.</source>
        <translation>Bei einem Randwinkel von {:.3g}° saugen die Garne kein Wasser; unter 90° saugen sie.</translation>
    </message>
    <message>
        <source>At a relative humidity of {} the air has more vapour than it can hold; it condenses on the cloth.</source>
        <translation>Bei einer relativen Feuchte von {} hat die Luft mehr Dampf, als sie halten kann; er kondensiert auf dem Stoff.</translation>
    </message>
    <message>
        <source>At most {} droplets are allowed; given are {}.</source>
        <translation>Höchstens {} Tropfen sind erlaubt; gegeben sind {}.</translation>
    </message>
    <message>
        <source>At {} the water is modelled as supercooled liquid; freezing is not modelled.</source>
        <translation>Bei {} gilt Wasser als unterkühlte Flüssigkeit; Gefrieren wird nicht berechnet.</translation>
    </message>
    <message>
        <source>Diameter {:.4g} and packing factor {:.4g} make {:.4g} of this fibre ({:.0f} kg/m3), but linear_density_tex says {:.4g}. They must agree within 1 %; leave one out.</source>
        <translation>Durchmesser {:.4g} und Packungsdichte {:.4g} ergeben {:.4g} von dieser Faser ({:.0f} kg/m³), die Fadenfeinheit sagt aber {:.4g}. Sie müssen auf 1 % übereinstimmen; lassen Sie eine Angabe weg.</translation>
    </message>
    <message>
        <source>Droplets {} and {} appear at the same time and overlap: {:.3g} apart, {:.3g} needed.</source>
        <translation>Die Tropfen {} und {} erscheinen zugleich und überlappen sich: Abstand {:.3g}, nötig {:.3g}.</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Kettfaden</translation>
    </message>
    <message>
        <source>No experiment of the study has the metric &quot;{}&quot;{} They have: {}.</source>
        <translation>Kein Versuch der Studie hat die Messgröße „{}“{} Sie haben: {}.</translation>
    </message>
    <message>
        <source>No {} of the study has &quot;{}&quot;, so this changes nothing. They have {}.</source>
        <translation>In der Studie ({}) kommt „{}“ nicht vor, daher ändert das nichts. Es kommen vor: {}.</translation>
    </message>
    <message>
        <source>One at a time the others change beside the project&apos;s own value, {}, which is not in the list; add it, or give &quot;base&quot;.</source>
        <translation>Einzeln ändern sich die anderen neben dem Wert des Projekts, {}, der nicht in der Liste steht; fügen Sie ihn hinzu, oder geben Sie „base“.</translation>
    </message>
    <message>
        <source>One period of the order may have up to {} threads; it has {}.</source>
        <translation>Eine Periode der Folge darf bis zu {} Fäden haben; sie hat {}.</translation>
    </message>
    <message>
        <source>Only a mesh has flat coordinates without a unit; leave uv_unit out of {}; given is &quot;{}&quot;.</source>
        <translation>Nur ein Netz hat flache Koordinaten ohne Einheit; lassen Sie die Einheit weg {}; gegeben ist „{}“.</translation>
    </message>
    <message>
        <source>Only a tee has sleeves; leave it out of a {}.</source>
        <translation>Nur ein T-Shirt hat Ärmel; lassen Sie die Angabe bei „{}“ weg.</translation>
    </message>
    <message>
        <source>Packed to {:.4g}, fibres touch all round (round ones from {:.4g}): liquid wicks along such yarns, but they neither absorb through their surface nor pass liquid on where they cross others.</source>
        <translation>Auf {:.4g} gepackt, berühren sich Fasern ringsum (runde ab {:.4g}): Flüssigkeit wird entlang solcher Garne gesaugt, doch nehmen sie keine durch ihre Oberfläche auf und geben keine an Garne weiter, die sie kreuzen.</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Schussfaden</translation>
    </message>
    <message>
        <source>Rates over time are a .csv beside the project; given is &quot;{}&quot;.</source>
        <translation>Raten über der Zeit sind eine .csv neben dem Projekt; gegeben ist „{}“.</translation>
    </message>
    <message>
        <source>The activity changes at {} s, not before the experiment&apos;s end at {} s.</source>
        <translation>Die Aktivität ändert sich bei {} s, nicht vor dem Ende des Versuchs bei {} s.</translation>
    </message>
    <message>
        <source>The areal density means a porosity of {:.3g}; given is {:.3g}. The areal density decides how much fibre there is.</source>
        <translation>Das Flächengewicht bedeutet eine Porosität von {:.3g}; gegeben ist {:.3g}. Das Flächengewicht entscheidet, wie viel Faser da ist.</translation>
    </message>
    <message>
        <source>The blend names &quot;{}&quot; twice.</source>
        <translation>Die Mischung nennt „{}“ zweimal.</translation>
    </message>
    <message>
        <source>The distribution begins at about {:.6g}, above which this must be; given is {}.</source>
        <translation>Die Verteilung beginnt bei etwa {:.6g}; der Wert muss darüber liegen; gegeben ist {}.</translation>
    </message>
    <message>
        <source>The distribution ends at about {:.6g}, below which this must be; given is {}.</source>
        <translation>Die Verteilung endet bei etwa {:.6g}; der Wert muss darunter liegen; gegeben ist {}.</translation>
    </message>
    <message>
        <source>The droplet appears at {} s, not before the experiment&apos;s end at {} s.</source>
        <translation>Der Tropfen erscheint bei {} s, nicht vor dem Ende des Versuchs bei {} s.</translation>
    </message>
    <message>
        <source>The droplet must land on the sample, from {:.4g} {}; given is {:.4g}.</source>
        <translation>Der Tropfen muss auf der Probe landen, von {:.4g} {}; gegeben ist {:.4g}.</translation>
    </message>
    <message>
        <source>The droplet, {:.3g} across, reaches over the sample&apos;s edge; some of it will miss the fabric.</source>
        <translation>Der Tropfen, {:.3g} breit, reicht über den Rand der Probe; ein Teil fällt neben das Gewebe.</translation>
    </message>
    <message>
        <source>The duration must be more than 0 s; given is 0.</source>
        <translation>Die Dauer muss mehr als 0 s sein; gegeben ist 0.</translation>
    </message>
    <message>
        <source>The ends of extra yarn {}</source>
        <translation>Die Kettfäden des weiteren Garns {}</translation>
    </message>
    <message>
        <source>The experiment has no droplet; nothing will get wet.</source>
        <translation>Der Versuch hat keinen Tropfen; nichts wird nass.</translation>
    </message>
    <message>
        <source>The interlaced yarns are {:.3g} thick; the other {:.3g} of the given thickness are flyaway fibres.</source>
        <translation>Die verkreuzten Garne sind {:.3g} dick; die übrigen {:.3g} der angegebenen Dicke sind abstehende Fasern.</translation>
    </message>
    <message>
        <source>The isotherm gives a regain of {:.3g} at 65 % relative humidity, standard_regain says {}; the isotherm is used.</source>
        <translation>Die Isotherme ergibt eine Feuchteaufnahme von {:.3g} bei 65 % relativer Feuchte, die Normalfeuchte ist {}; die Isotherme gilt.</translation>
    </message>
    <message>
        <source>The laboratory&apos;s value means yarns packed from {:.3g} to {:.3g}; the sections that follow from sett, thickness and diameters can hold from {} to {}. Derived are {:.4g} g/m2.</source>
        <translation>Der Laborwert bedeutet Garne, die von {:.3g} bis {:.3g} gepackt sind; die Querschnitte aus Dichte, Dicke und Durchmessern fassen von {} bis {}. Berechnet sind {:.4g} g/m².</translation>
    </message>
    <message>
        <source>The library has no material &quot;{}&quot;.</source>
        <translation>Die Bibliothek hat kein Material „{}“.</translation>
    </message>
    <message>
        <source>The longest {} float passes {} {} threads, {:.3g} on the {}; floats over {} snag.</source>
        <translation>Die längste Flottierung ({}) läuft {} {} Fäden, {:.3g} auf der {}; Flottierungen über {} bleiben hängen.</translation>
    </message>
    <message>
        <source>The name &quot;{}&quot; is taken; names must differ.</source>
        <translation>Der Name „{}“ ist vergeben; Namen müssen sich unterscheiden.</translation>
    </message>
    <message>
        <source>The name has a line break; write it in one line.</source>
        <translation>Der Name hat einen Zeilenumbruch; schreiben Sie ihn in eine Zeile.</translation>
    </message>
    <message>
        <source>The name has {} bytes; 200 at most.</source>
        <translation>Der Name hat {} Bytes; höchstens 200.</translation>
    </message>
    <message>
        <source>The name is empty; give one.</source>
        <translation>Der Name ist leer; geben Sie einen.</translation>
    </message>
    <message>
        <source>The name of a panel is empty; give one.</source>
        <translation>Der Name eines Schnittteils ist leer; geben Sie einen.</translation>
    </message>
    <message>
        <source>The name of a zone is empty; give one.</source>
        <translation>Der Name einer Zone ist leer; geben Sie einen.</translation>
    </message>
    <message>
        <source>The order has {} different yarns, colours apart; {} is the most.</source>
        <translation>Die Folge hat {} verschiedene Garne, Farben nicht gezählt; höchstens {} sind erlaubt.</translation>
    </message>
    <message>
        <source>The outline of a zone has from 3 to {} places; given are {}.</source>
        <translation>Der Umriss einer Zone hat 3 bis {} Punkte; gegeben sind {}.</translation>
    </message>
    <message>
        <source>The outline of the zone &quot;{}&quot; crosses itself; what it goes round twice is left out.</source>
        <translation>Der Umriss der Zone „{}“ kreuzt sich; was er zweimal umläuft, bleibt weg.</translation>
    </message>
    <message>
        <source>The panel of a zone is empty; name one of the garment&apos;s.</source>
        <translation>Das Schnittteil einer Zone ist leer; nennen Sie eines des Kleidungsstücks.</translation>
    </message>
    <message>
        <source>The pattern has no panel &quot;{}&quot;{} It has {}{}.</source>
        <translation>Der Schnitt hat kein Schnittteil „{}“{} Er hat {}{}.</translation>
    </message>
    <message>
        <source>The picks of extra yarn {}</source>
        <translation>Die Schussfäden des weiteren Garns {}</translation>
    </message>
    <message>
        <source>The project has no fabric &quot;{}&quot;{}</source>
        <translation>Das Projekt hat kein Gewebe „{}“{}</translation>
    </message>
    <message>
        <source>The project has no {} that a study can run.</source>
        <translation>Im Projekt fehlt, was eine Studie laufen lassen kann: {}.</translation>
    </message>
    <message>
        <source>The project has several {}s; list those to run: {}.</source>
        <translation>Das Projekt hat mehr als einen Eintrag ({}); nennen Sie, welche laufen: {}.</translation>
    </message>
    <message>
        <source>The receding angle, {} degrees, cannot be above the contact angle, {}.</source>
        <translation>Der Rückzugswinkel, {}°, kann nicht über dem Randwinkel, {}°, liegen.</translation>
    </message>
    <message>
        <source>The regain at 100 % relative humidity, {}, cannot be less than the one at 65 %, {}.</source>
        <translation>Die Feuchteaufnahme bei 100 % relativer Feuchte, {}, kann nicht kleiner sein als die bei 65 %, {}.</translation>
    </message>
    <message>
        <source>The relative humidity must be from 0 to {}; given is {}. It is a fraction: {:.4g} for {:.4g} %.</source>
        <translation>Die relative Feuchte muss von 0 bis {} sein; gegeben ist {}. Sie ist ein Bruchteil: {:.4g} für {:.4g} %.</translation>
    </message>
    <message>
        <source>The seam &quot;{}&quot; is named twice, once in each order; leave one.</source>
        <translation>Die Naht „{}“ ist zweimal genannt, einmal in jeder Reihenfolge; lassen Sie eine.</translation>
    </message>
    <message>
        <source>The shares of the blend must sum to 1; they sum to {}.</source>
        <translation>Die Anteile der Mischung müssen zusammen 1 sein; sie sind zusammen {}.</translation>
    </message>
    <message>
        <source>The strip must dip into the liquid by more than 0 and less than the strip&apos;s length of {:.4g}; given is {:.4g}.</source>
        <translation>Der Streifen muss mehr als 0 und weniger als seine Länge von {:.4g} tief eintauchen; gegeben ist {:.4g}.</translation>
    </message>
    <message>
        <source>The study does not run the {} &quot;{}&quot;, so this changes nothing. It runs {}.</source>
        <translation>In der Studie läuft nicht: {} „{}“; daher ändert das nichts. Es laufen {}.</translation>
    </message>
    <message>
        <source>The study runs no garment, so this changes nothing.</source>
        <translation>Die Studie lässt kein Kleidungsstück laufen, daher ändert das nichts.</translation>
    </message>
    <message>
        <source>The times of a climate must rise, up to 86400 s: after {} s; given is {}.</source>
        <translation>Die Zeiten eines Klimas müssen steigen, bis 86400 s: nach {} s; gegeben ist {}.</translation>
    </message>
    <message>
        <source>The volume of each drop of the feed must be 0 (the feed flows evenly) or at least {} ul; given is {}.</source>
        <translation>Das Volumen jedes Tropfens der Zufuhr muss 0 sein (sie fließt gleichmäßig) oder mindestens {} µl; gegeben ist {}.</translation>
    </message>
    <message>
        <source>The warp yarns</source>
        <translation>Die Kettgarne</translation>
    </message>
    <message>
        <source>The weave falls into {} cloths that lie on one another without being joined; the upper one has {} of the repeat&apos;s {} ends and {} of its {} picks.</source>
        <translation>Die Bindung zerfällt in {} Gewebe, die unverbunden aufeinander liegen; das obere hat {} von {} Kettfäden und {} von {} Schussfäden des Rapports.</translation>
    </message>
    <message>
        <source>The weft yarns</source>
        <translation>Die Schussgarne</translation>
    </message>
    <message>
        <source>The yarn has no material; give a name or a blend.</source>
        <translation>Das Garn hat kein Material; geben Sie einen Namen oder eine Mischung.</translation>
    </message>
    <message>
        <source>The yarn needs a count or a diameter (count, linear_density_tex, diameter_mm); none is given.</source>
        <translation>Das Garn braucht eine Feinheit oder einen Durchmesser; keines ist gegeben.</translation>
    </message>
    <message>
        <source>The zone &quot;{}&quot; lies beside the panel &quot;{}&quot;, which reaches from x {:.0f}, y {:.0f} to x {:.0f}, y {:.0f}.</source>
        <translation>Die Zone „{}“ liegt neben dem Schnittteil „{}“, das von x {:.0f}, y {:.0f} bis x {:.0f}, y {:.0f} reicht.</translation>
    </message>
    <message>
        <source>The {} must be from {}.</source>
        <translation>{}: Erlaubt ist {}.</translation>
    </message>
    <message>
        <source>The {} must be from {}; given is {}.</source>
        <translation>{}: Erlaubt ist {}; gegeben ist {}.</translation>
    </message>
    <message>
        <source>The {}&apos;s crimp is set to {:.3g} %; yarns of these sections and setts can have {:.3g} %.</source>
        <translation>Die Einwebung ({}) ist auf {:.3g} % gesetzt; Garne mit diesen Querschnitten und Dichten können {:.3g} % haben.</translation>
    </message>
    <message>
        <source>There are two own zones &quot;{}&quot;; give one another name.</source>
        <translation>Es gibt zwei eigene Zonen „{}“; geben Sie einer einen anderen Namen.</translation>
    </message>
    <message>
        <source>There is no built-in garment &quot;{}&quot;; there are {}.</source>
        <translation>Es gibt kein eingebautes Kleidungsstück „{}“; es gibt {}.</translation>
    </message>
    <message>
        <source>There is no garment named &quot;{}&quot; in the project.</source>
        <translation>Im Projekt heißt kein Kleidungsstück „{}“.</translation>
    </message>
    <message>
        <source>There is no liquid &quot;{}&quot;{} There are water, saline, sweat and the project&apos;s own.</source>
        <translation>Es gibt keine Flüssigkeit „{}“{} Es gibt Wasser (water), Salzlösung (saline), Schweiß (sweat) und die des Projekts.</translation>
    </message>
    <message>
        <source>There is no liquid named &quot;{}&quot; in the project or the library.</source>
        <translation>Weder im Projekt noch in der Bibliothek heißt eine Flüssigkeit „{}“.</translation>
    </message>
    <message>
        <source>There is no material &quot;{}&quot;{} Known are: {}.</source>
        <translation>Es gibt kein Material „{}“{} Bekannt sind: {}.</translation>
    </message>
    <message>
        <source>There is no table of sweat rates &quot;{}&quot;; there are {}, or name a file that ends in .csv.</source>
        <translation>Es gibt keine Tabelle der Schweißraten „{}“; es gibt {}, oder nennen Sie eine Datei, die auf .csv endet.</translation>
    </message>
    <message>
        <source>There is no zone &quot;{}&quot; of the body{} There are &quot;default&quot;, {}.</source>
        <translation>Der Körper hat keine Zone „{}“{} Es gibt „default“, {}.</translation>
    </message>
    <message>
        <source>This is the same value as factors[{}], &quot;{}&quot;; leave one.</source>
        <translation>Das ist derselbe Wert wie factors[{}], „{}“; lassen Sie einen.</translation>
    </message>
    <message>
        <source>This must be a number; given is &quot;{}&quot;.</source>
        <translation>Das muss eine Zahl sein; gegeben ist „{}“.</translation>
    </message>
    <message>
        <source>This must be one of &quot;values&quot;; given is {}.</source>
        <translation>Das muss einer der „values“ sein; gegeben ist {}.</translation>
    </message>
    <message>
        <source>Yarns are flattened at crossings: the sett is too dense for round yarns (Peirce).</source>
        <translation>Garne sind an Kreuzungen abgeflacht: Für runde Garne ist die Fadendichte zu hoch (Peirce).</translation>
    </message>
    <message>
        <source>&quot;{}&quot; and &quot;{}&quot; are not sewn together.</source>
        <translation>„{}“ und „{}“ sind nicht zusammengenäht.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is a zone of the body; give a zone of your own another name.</source>
        <translation>„{}“ ist eine Zone des Körpers; geben Sie einer eigenen Zone einen anderen Namen.</translation>
    </message>
    <message>
        <source>a built-in garment</source>
        <translation>bei einem eingebauten Kleidungsstück</translation>
    </message>
    <message>
        <source>a pattern</source>
        <translation>bei einem Schnitt</translation>
    </message>
    <message>
        <source>along the warp</source>
        <translation>entlang der Kette</translation>
    </message>
    <message>
        <source>along the weft</source>
        <translation>entlang dem Schuss</translation>
    </message>
    <message>
        <source>are {:.0f} % of the limit of sett for these yarns and this weave; looms stop at about {:.0f} %</source>
        <translation>sind {:.0f} % der Grenzdichte dieser Garne in dieser Bindung; Webmaschinen enden bei etwa {:.0f} %</translation>
    </message>
    <message>
        <source>diameter that follows from the linear density</source>
        <translation>Durchmesser, der aus der Fadenfeinheit folgt</translation>
    </message>
    <message>
        <source>diffusivity of water in the fibre</source>
        <translation>Diffusionskoeffizient von Wasser in der Faser</translation>
    </message>
    <message>
        <source>experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>fabric</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Oberseite</translation>
    </message>
    <message>
        <source>gap between skin and cloth</source>
        <translation>Abstand zwischen Haut und Stoff</translation>
    </message>
    <message>
        <source>leave these yarns no room to bend round each other, flattened and squeezed as close as they can be</source>
        <translation>lassen diesen Garnen keinen Platz, sich umeinander zu biegen, so flach und dicht sie auch gepresst sind</translation>
    </message>
    <message>
        <source>number of the yarn (0: the fabric&apos;s own, then extra_yarns from 1)</source>
        <translation>Nummer des Garns (0: das des Gewebes, dann die weiteren Garne ab 1)</translation>
    </message>
    <message>
        <source>number of threads in a run</source>
        <translation>Zahl der Fäden nebeneinander</translation>
    </message>
    <message>
        <source>over</source>
        <translation>über</translation>
    </message>
    <message>
        <source>perimeter of a fibre over that of a circle of the same area</source>
        <translation>Umfang einer Faser zu dem eines Kreises gleicher Fläche</translation>
    </message>
    <message>
        <source>radius of a fibre that follows from the number of filaments</source>
        <translation>Faserradius, der aus der Filamentzahl folgt</translation>
    </message>
    <message>
        <source>residual of a calibration</source>
        <translation>Restabweichung einer Kalibrierung</translation>
    </message>
    <message>
        <source>sample&apos;s size</source>
        <translation>Größe der Probe</translation>
    </message>
    <message>
        <source>share of the water that a seam lets through</source>
        <translation>Anteil des Wassers, den eine Naht durchlässt</translation>
    </message>
    <message>
        <source>strip&apos;s size</source>
        <translation>Größe des Streifens</translation>
    </message>
    <message>
        <source>to bend round each other</source>
        <translation>um sich umeinander zu biegen</translation>
    </message>
    <message>
        <source>to fit the thickness</source>
        <translation>um in die Dicke zu passen</translation>
    </message>
    <message>
        <source>under</source>
        <translation>unter</translation>
    </message>
    <message>
        <source>x of a place</source>
        <translation>x eines Punkts</translation>
    </message>
    <message>
        <source>y of a place</source>
        <translation>y eines Punkts</translation>
    </message>
    <message>
        <source>{:.4g} ends and {:.4g} picks per {} {}. Lower a sett, or give finer yarns or longer floats.</source>
        <translation>{:.4g} Kett- und {:.4g} Schussfäden je {} {}. Senken Sie eine Fadendichte, oder geben Sie feinere Garne oder längere Flottierungen.</translation>
    </message>
    <message>
        <source>{:.4g} of this fibre ({:.0f} kg/m3) in a diameter of {:.4g} is a packing factor of {:.3g}; it must be from {} to {}.</source>
        <translation>{:.4g} von dieser Faser ({:.0f} kg/m³) in einem Durchmesser von {:.4g} sind eine Packungsdichte von {:.3g}; erlaubt ist {} bis {}.</translation>
    </message>
    <message>
        <source>{:.4g} of this fibre in a diameter of {:.3g} is a packing factor of {:.3g}; usual yarns are packed to {} to {}. Leave the diameter or the linear density empty, and it is calculated.</source>
        <translation>{:.4g} von dieser Faser in einem Durchmesser von {:.3g} sind eine Packungsdichte von {:.3g}; übliche Garne haben {} bis {}. Lassen Sie Durchmesser oder Fadenfeinheit leer, dann werden sie berechnet.</translation>
    </message>
    <message>
        <source>{:.4g} of {} filaments ({:.0f} kg/m3) make a fibre radius of {:.3g}, which counts; that of {} is {:.3g} and is left aside.</source>
        <translation>{:.4g} aus {} Filamenten ({:.0f} kg/m³) ergeben einen Faserradius von {:.3g}, der gilt; der von {} ist {:.3g} und bleibt außer Acht.</translation>
    </message>
    <message>
        <source>{:.4g} {} do not fit: a yarn of {:.3g} ({:.3g}) has {:.2g} x {:.2g} of room; the packing would be {:.3g}, the limit is {}. Lower the sett, or give a finer yarn or more thickness.</source>
        <translation>{:.4g} {} passen nicht: Ein Garn von {:.3g} ({:.3g}) hat {:.2g} x {:.2g} Platz; die Packungsdichte wäre {:.3g}, die Grenze ist {}. Senken Sie die Fadendichte, oder geben Sie ein feineres Garn oder mehr Dicke.</translation>
    </message>
    <message>
        <source>{} are loosened from a packing of {:.3g} to {:.3g}, to fill the thickness.</source>
        <translation>{} sind von einer Packungsdichte von {:.3g} auf {:.3g} gelockert, um die Dicke zu füllen.</translation>
    </message>
    <message>
        <source>{} are narrowed to {:.3g}, 98 % of their pitch of {:.3g}; their packing factor rises from {:.3g} to {:.3g}.</source>
        <translation>{} sind auf {:.3g} verschmälert, 98 % ihres Abstands von {:.3g}; ihre Packungsdichte steigt von {:.3g} auf {:.3g}.</translation>
    </message>
    <message>
        <source>{} become {:.3g} wide where they cross.</source>
        <translation>{} werden {:.3g} breit, wo sie sich kreuzen.</translation>
    </message>
    <message>
        <source>{} drawn fibres do not fill {} plies; give at least one for each.</source>
        <translation>{} gezeichnete Fasern füllen {} Einzelgarne nicht; geben Sie mindestens eine für jedes.</translation>
    </message>
    <message>
        <source>{} have {:.0f} % of their area on average, as the crossed yarns squeeze them between crossings; they are packed to {:.3g}.</source>
        <translation>{} haben im Mittel {:.0f} % ihrer Fläche, da die gekreuzten Garne sie zwischen Kreuzungen pressen; sie sind auf {:.3g} gepackt.</translation>
    </message>
    <message>
        <source>{} points with {} runs each are more than {} rows; take fewer points, fabrics, experiments or replicates.</source>
        <translation>{} Punkte mit je {} Läufen sind mehr als {} Zeilen; nehmen Sie weniger Punkte, Gewebe, Versuche oder Wiederholungen.</translation>
    </message>
    <message>
        <source>{} {} and {} more never interlace.</source>
        <translation>{} {} und {} weitere binden nie ab.</translation>
    </message>
    <message>
        <source>{} {} never interlaces.</source>
        <translation>{} {} bindet nie ab.</translation>
    </message>
    <message>
        <source>{}, {:.3g} across when free, are flattened to {:.3g} of height {}.</source>
        <translation>{}, frei {:.3g} breit, sind auf {:.3g} Höhe abgeflacht, {}.</translation>
    </message>
    <message>
        <source>{}{} of yarn {} (extra yarn {})</source>
        <translation>{}{} von Garn {} (weiteres Garn {})</translation>
    </message>
    <message>
        <source>{}{}</source>
        <translation>{}{}</translation>
    </message>
    <message>
        <source>A study runs samples of fabric or garments (type wear), not both; list experiments of one kind.</source>
        <translation>Eine Studie rechnet Stoffproben oder Kleidungsstücke (Art wear), nicht beides; nennen Sie Versuche einer Art.</translation>
    </message>
    <message>
        <source>The error of garments is not known; name a fidelity.</source>
        <translation>Der Fehler von Kleidungsstücken ist nicht bekannt; nennen Sie eine Genauigkeit.</translation>
    </message>
    <message>
        <source>The project has no {} &quot;{}&quot;{} It has {}.</source>
        <translation>Im Projekt ({}) gibt es „{}“ nicht{} Es gibt: {}.</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>garment</source>
        <translation>Kleidungsstück</translation>
    </message>
    <message>
        <source>on the skin</source>
        <translation>auf der Haut</translation>
    </message>
    <message>
        <source>share of capacity</source>
        <translation>Füllgrad</translation>
    </message>
    <message>
        <source>time until full</source>
        <translation>Zeit bis voll</translation>
    </message>
    <message>
        <source>water per area</source>
        <translation>Wasser je Fläche</translation>
    </message>
    <message>
        <source>wet area</source>
        <translation>nasse Fläche</translation>
    </message>
    <message>
        <source>The study cuts the garment from its own list of fabrics, so this changes nothing.</source>
        <translation>Die Studie schneidet das Kleidungsstück aus ihrer eigenen Liste von Geweben, daher ändert das nichts.</translation>
    </message>
    <message>
        <source>panel %1</source>
        <translation>Schnittteil %1</translation>
    </message>
    <message>
        <source>zone %1</source>
        <translation>Zone %1</translation>
    </message>
    <message>
        <source>capacity</source>
        <translation>Fassungsvermögen</translation>
    </message>
    <message>
        <source>dripped</source>
        <translation>abgetropft</translation>
    </message>
    <message>
        <source>heat from the skin</source>
        <translation>Wärme von der Haut</translation>
    </message>
    <message>
        <source>heat that evaporating took</source>
        <translation>Wärme, die das Verdunsten nahm</translation>
    </message>
    <message>
        <source>it never holds 90 % of what it can</source>
        <translation>es hält nie 90 % dessen, was es kann</translation>
    </message>
    <message>
        <source>it took up no water, is not left to dry, or more than 5 % of the most water is left</source>
        <translation>es nahm kein Wasser auf, es bleibt keine Zeit zum Trocknen, oder mehr als 5 % des meisten Wassers sind noch da</translation>
    </message>
    <message>
        <source>largest wet area</source>
        <translation>größte nasse Fläche</translation>
    </message>
    <message>
        <source>most water</source>
        <translation>meistes Wasser</translation>
    </message>
    <message>
        <source>there is no water</source>
        <translation>es ist kein Wasser da</translation>
    </message>
    <message>
        <source>water at the skin&apos;s face</source>
        <translation>Wasser auf der Hautseite</translation>
    </message>
    <message>
        <source>Ends a dent</source>
        <translation>Fäden je Rohr</translation>
    </message>
    <message>
        <source>Ends in the reed</source>
        <translation>Kettdichte im Blatt</translation>
    </message>
    <message>
        <source>Of a kilogram. The card tells costs in the same currency.</source>
        <translation>Eines Kilogramms. Die Karte nennt Kosten in derselben Währung.</translation>
    </message>
    <message>
        <source>Of the reed.</source>
        <translation>Des Blatts.</translation>
    </message>
    <message>
        <source>Of the warp in the reed. Leave empty to compute it from the ends in the reed.</source>
        <translation>Der Kette im Blatt. Leer lassen, um sie aus der Kettdichte im Blatt zu berechnen.</translation>
    </message>
    <message>
        <source>On the loom. Leave empty to compute it from the reed width.</source>
        <translation>Auf dem Webstuhl. Leer lassen, um sie aus der Blattbreite zu berechnen.</translation>
    </message>
    <message>
        <source>On the loom. Leave empty where the cloth keeps its length.</source>
        <translation>Auf dem Webstuhl. Leer lassen, wenn das Gewebe seine Länge behält.</translation>
    </message>
    <message>
        <source>Picks on the loom</source>
        <translation>Schussdichte auf dem Webstuhl</translation>
    </message>
    <message>
        <source>Price</source>
        <translation>Preis</translation>
    </message>
    <message>
        <source>Reed width</source>
        <translation>Blattbreite</translation>
    </message>
    <message>
        <source>Absorbency time</source>
        <translation>Aufnahmezeit</translation>
    </message>
    <message>
        <source>Absorption capacity, drained</source>
        <translation>Aufnahmevermögen, abgetropft</translation>
    </message>
    <message>
        <source>Absorption capacity, full</source>
        <translation>Aufnahmevermögen, voll</translation>
    </message>
    <message>
        <source>Absorption rate, bottom</source>
        <translation>Aufnahmerate, unten</translation>
    </message>
    <message>
        <source>Absorption rate, top</source>
        <translation>Aufnahmerate, oben</translation>
    </message>
    <message>
        <source>Air permeability at 100 Pa</source>
        <translation>Luftdurchlässigkeit bei 100 Pa</translation>
    </message>
    <message>
        <source>Air permeability at 125 Pa</source>
        <translation>Luftdurchlässigkeit bei 125 Pa</translation>
    </message>
    <message>
        <source>Air permeability at 200 Pa</source>
        <translation>Luftdurchlässigkeit bei 200 Pa</translation>
    </message>
    <message>
        <source>Area of the stain after 1 min</source>
        <translation>Fläche des Flecks nach 1 min</translation>
    </message>
    <message>
        <source>Cover</source>
        <translation>Deckung</translation>
    </message>
    <message>
        <source>Drying index</source>
        <translation>Trocknungsindex</translation>
    </message>
    <message>
        <source>Drying rate</source>
        <translation>Trocknungsrate</translation>
    </message>
    <message>
        <source>Drying time</source>
        <translation>Trocknungszeit</translation>
    </message>
    <message>
        <source>Half-change time of the regain</source>
        <translation>Halbwertszeit der Feuchteaufnahme</translation>
    </message>
    <message>
        <source>Hydrostatic head</source>
        <translation>Wassersäule</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Flächenmasse</translation>
    </message>
    <message>
        <source>One-way transport</source>
        <translation>Einwegtransport</translation>
    </message>
    <message>
        <source>Open area</source>
        <translation>Offene Fläche</translation>
    </message>
    <message>
        <source>Overall capability (OMMC)</source>
        <translation>Feuchtemanagement gesamt (OMMC)</translation>
    </message>
    <message>
        <source>Permeability index</source>
        <translation>Durchlässigkeitsindex</translation>
    </message>
    <message>
        <source>Porosity, as drawn</source>
        <translation>Porosität, wie gezeichnet</translation>
    </message>
    <message>
        <source>Regain at 65 % humidity</source>
        <translation>Feuchteaufnahme bei 65 % Feuchte</translation>
    </message>
    <message>
        <source>Retention after spinning</source>
        <translation>Restfeuchte nach dem Schleudern</translation>
    </message>
    <message>
        <source>Spreading speed, bottom</source>
        <translation>Ausbreitungsgeschwindigkeit, unten</translation>
    </message>
    <message>
        <source>Spreading speed, top</source>
        <translation>Ausbreitungsgeschwindigkeit, oben</translation>
    </message>
    <message>
        <source>Thermal resistance Rct</source>
        <translation>Wärmedurchgangswiderstand Rct</translation>
    </message>
    <message>
        <source>Thickness at 1 kPa</source>
        <translation>Dicke bei 1 kPa</translation>
    </message>
    <message>
        <source>Thickness, as drawn</source>
        <translation>Dicke, wie gezeichnet</translation>
    </message>
    <message>
        <source>Vapour permeability</source>
        <translation>Dampfdurchlässigkeit</translation>
    </message>
    <message>
        <source>Vapour transmission, cup with calcium chloride</source>
        <translation>Dampfdurchgang, Becher mit Calciumchlorid</translation>
    </message>
    <message>
        <source>Vapour transmission, inverted cup with water</source>
        <translation>Dampfdurchgang, umgedrehter Becher mit Wasser</translation>
    </message>
    <message>
        <source>Vapour transmission, upright cup with water</source>
        <translation>Dampfdurchgang, stehender Becher mit Wasser</translation>
    </message>
    <message>
        <source>Warm-cool feeling q-max</source>
        <translation>Warm-kühl-Empfinden q-max</translation>
    </message>
    <message>
        <source>Water drawn in along the warp, 10 min</source>
        <translation>Aufgesaugtes Wasser in Kettrichtung, 10 min</translation>
    </message>
    <message>
        <source>Water drawn in along the warp, 30 min</source>
        <translation>Aufgesaugtes Wasser in Kettrichtung, 30 min</translation>
    </message>
    <message>
        <source>Water drawn in along the warp, 5 min</source>
        <translation>Aufgesaugtes Wasser in Kettrichtung, 5 min</translation>
    </message>
    <message>
        <source>Water drawn in along the weft, 10 min</source>
        <translation>Aufgesaugtes Wasser in Schussrichtung, 10 min</translation>
    </message>
    <message>
        <source>Water drawn in along the weft, 30 min</source>
        <translation>Aufgesaugtes Wasser in Schussrichtung, 30 min</translation>
    </message>
    <message>
        <source>Water drawn in along the weft, 5 min</source>
        <translation>Aufgesaugtes Wasser in Schussrichtung, 5 min</translation>
    </message>
    <message>
        <source>Water-vapour resistance Ret</source>
        <translation>Wasserdampfdurchgangswiderstand Ret</translation>
    </message>
    <message>
        <source>Wetted radius, bottom</source>
        <translation>Benetzungsradius, unten</translation>
    </message>
    <message>
        <source>Wetted radius, top</source>
        <translation>Benetzungsradius, oben</translation>
    </message>
    <message>
        <source>Wetting time, bottom</source>
        <translation>Benetzungszeit, unten</translation>
    </message>
    <message>
        <source>Wetting time, top</source>
        <translation>Benetzungszeit, oben</translation>
    </message>
    <message>
        <source>Wicking height along the warp, 10 min</source>
        <translation>Steighöhe in Kettrichtung, 10 min</translation>
    </message>
    <message>
        <source>Wicking height along the warp, 30 min</source>
        <translation>Steighöhe in Kettrichtung, 30 min</translation>
    </message>
    <message>
        <source>Wicking height along the warp, 5 min</source>
        <translation>Steighöhe in Kettrichtung, 5 min</translation>
    </message>
    <message>
        <source>Wicking height along the weft, 10 min</source>
        <translation>Steighöhe in Schussrichtung, 10 min</translation>
    </message>
    <message>
        <source>Wicking height along the weft, 30 min</source>
        <translation>Steighöhe in Schussrichtung, 30 min</translation>
    </message>
    <message>
        <source>Wicking height along the weft, 5 min</source>
        <translation>Steighöhe in Schussrichtung, 5 min</translation>
    </message>
    <message>
        <source>Yarn cost of a metre</source>
        <translation>Garnkosten eines Meters</translation>
    </message>
    <message>
        <source>drying index</source>
        <translation>Trocknungsindex</translation>
    </message>
    <message>
        <source>height after 10 min</source>
        <translation>Steighöhe nach 10 min</translation>
    </message>
    <message>
        <source>height after 30 min</source>
        <translation>Steighöhe nach 30 min</translation>
    </message>
    <message>
        <source>height after 5 min</source>
        <translation>Steighöhe nach 5 min</translation>
    </message>
    <message>
        <source>water drawn in after 10 min, per width</source>
        <translation>aufgesaugtes Wasser nach 10 min, je Breite</translation>
    </message>
    <message>
        <source>water drawn in after 30 min, per width</source>
        <translation>aufgesaugtes Wasser nach 30 min, je Breite</translation>
    </message>
    <message>
        <source>water drawn in after 5 min, per width</source>
        <translation>aufgesaugtes Wasser nach 5 min, je Breite</translation>
    </message>
    <message>
        <source>Core</source>
        <translation>Kern</translation>
    </message>
    <message>
        <source>Ends on the loom</source>
        <translation>Kettdichte auf dem Webstuhl</translation>
    </message>
    <message>
        <source>Ends, all</source>
        <translation>Kettfäden, gesamt</translation>
    </message>
    <message>
        <source>Ends, finished</source>
        <translation>Kettdichte, fertig</translation>
    </message>
    <message>
        <source>Fibres</source>
        <translation>Fasern</translation>
    </message>
    <message>
        <source>Picks, finished</source>
        <translation>Schussdichte, fertig</translation>
    </message>
    <message>
        <source>Reed</source>
        <translation>Webblatt</translation>
    </message>
    <message>
        <source>Shrinks in length</source>
        <translation>Springt in der Länge ein</translation>
    </message>
    <message>
        <source>Shrinks in width</source>
        <translation>Springt in der Breite ein</translation>
    </message>
    <message>
        <source>Speed of wicking along the warp, level strip</source>
        <translation>Sauggeschwindigkeit längs der Kette, liegender Streifen</translation>
    </message>
    <message>
        <source>Speed of wicking along the weft, level strip</source>
        <translation>Sauggeschwindigkeit längs des Schusses, liegender Streifen</translation>
    </message>
    <message>
        <source>Warp: count</source>
        <translation>Kette: Feinheit</translation>
    </message>
    <message>
        <source>Warp: crimp</source>
        <translation>Kette: Einarbeitung</translation>
    </message>
    <message>
        <source>Weft: count</source>
        <translation>Schuss: Feinheit</translation>
    </message>
    <message>
        <source>Weft: crimp</source>
        <translation>Schuss: Einarbeitung</translation>
    </message>
    <message>
        <source>Width, finished</source>
        <translation>Breite, fertig</translation>
    </message>
</context>
<context>
    <name>hygroloom</name>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>%1 µm</source>
        <translation>%1 µm</translation>
    </message>
    <message>
        <source>Smaller is better.</source>
        <translation>Kleiner ist besser.</translation>
    </message>
    <message>
        <source>Larger is better.</source>
        <translation>Größer ist besser.</translation>
    </message>
    <message>
        <source>%1 of %2 runs</source>
        <translation>%1 von %2 Läufen</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>Bezug</translation>
    </message>
    <message>
        <source>Difference to %1: %2 to %3 %4, from %5.</source>
        <translation>Unterschied zu %1: %2 bis %3 %4, aus %5.</translation>
    </message>
    <message>
        <source>one run of each</source>
        <translation>je einem Lauf</translation>
    </message>
    <message>
        <source>%1 pairs of runs</source>
        <translation>%1 Paaren von Läufen</translation>
    </message>
    <message>
        <source>measured %1</source>
        <translation>gemessen %1</translation>
    </message>
    <message>
        <source>This run does not give this number.</source>
        <translation>Dieser Lauf ergibt diese Zahl nicht.</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>After ±: where one more such cloth is expected, from %1 runs with numerical error, scatter and what is not known of the cloth.</source>
        <translation>Nach ±: wo ein weiteres solches Gewebe zu erwarten ist, aus %1 Läufen, mit numerischem Fehler, Streuung und dem, was vom Gewebe nicht bekannt ist.</translation>
    </message>
    <message>
        <source>After ±: the numerical error, as measured on runs of this kind.</source>
        <translation>Nach ±: der numerische Fehler, gemessen an Läufen dieser Art.</translation>
    </message>
    <message>
        <source>The numerical error of this number is not known.</source>
        <translation>Der numerische Fehler dieser Zahl ist nicht bekannt.</translation>
    </message>
    <message>
        <source>better</source>
        <translation>besser</translation>
    </message>
    <message>
        <source>probably better</source>
        <translation>wohl besser</translation>
    </message>
    <message>
        <source>no difference shown</source>
        <translation>kein Unterschied gezeigt</translation>
    </message>
    <message>
        <source>probably worse</source>
        <translation>wohl schlechter</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>schlechter</translation>
    </message>
    <message>
        <source>grade %1</source>
        <translation>Note %1</translation>
    </message>
    <message>
        <source>The recording does not contain its fabric.</source>
        <translation>Die Aufzeichnung enthält ihr Gewebe nicht.</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>remove garment</source>
        <translation>Kleidungsstück entfernen</translation>
    </message>
    <message>
        <source>A garment needs a name.</source>
        <translation>Ein Kleidungsstück braucht einen Namen.</translation>
    </message>
    <message>
        <source>A garment “%1” already exists. Choose another name.</source>
        <translation>Ein Kleidungsstück „%1“ gibt es schon. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>An experiment needs a name.</source>
        <translation>Ein Versuch braucht einen Namen.</translation>
    </message>
    <message>
        <source>An experiment “%1” already exists. Choose another name.</source>
        <translation>Einen Versuch „%1“ gibt es schon. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>rename garment</source>
        <translation>Kleidungsstück umbenennen</translation>
    </message>
    <message>
        <source>rename wear experiment</source>
        <translation>Trageversuch umbenennen</translation>
    </message>
    <message>
        <source>cut all panels from %1</source>
        <translation>alle Schnittteile aus %1 zuschneiden</translation>
    </message>
    <message>
        <source>A zone needs a name.</source>
        <translation>Eine Zone braucht einen Namen.</translation>
    </message>
    <message>
        <source>“%1” is a zone of the body. Choose another name.</source>
        <translation>„%1“ ist eine Zone des Körpers. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>A zone “%1” already exists. Choose another name.</source>
        <translation>Eine Zone „%1“ gibt es schon. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>draw a zone</source>
        <translation>Zone zeichnen</translation>
    </message>
    <message>
        <source>delete zone</source>
        <translation>Zone löschen</translation>
    </message>
    <message>
        <source>add wear experiment</source>
        <translation>Trageversuch hinzufügen</translation>
    </message>
    <message>
        <source>remove wear experiment</source>
        <translation>Trageversuch entfernen</translation>
    </message>
    <message>
        <source>Garment</source>
        <translation>Kleidungsstück</translation>
    </message>
    <message>
        <source>Panel: %1</source>
        <translation>Schnittteil: %1</translation>
    </message>
    <message>
        <source>Zone: %1</source>
        <translation>Zone: %1</translation>
    </message>
    <message>
        <source>the cloth lies level here</source>
        <translation>der Stoff liegt hier waagerecht</translation>
    </message>
    <message>
        <source>the warp runs down here</source>
        <translation>die Kette läuft hier abwärts</translation>
    </message>
    <message>
        <source>the weft runs down here</source>
        <translation>der Schuss läuft hier abwärts</translation>
    </message>
    <message>
        <source>the bias runs down here, %1° from the warp</source>
        <translation>der Schrägzug läuft hier abwärts, %1° von der Kette</translation>
    </message>
    <message>
        <source>The graphics driver rejected a shader: %1</source>
        <translation>Der Grafiktreiber hat einen Shader abgelehnt: %1</translation>
    </message>
    <message>
        <source>The picture needs OpenGL 3.3, which this display does not provide.</source>
        <translation>Das Bild braucht OpenGL 3.3, das diese Anzeige nicht bietet.</translation>
    </message>
    <message>
        <source>the wetted radius, top</source>
        <translation>des Benetzungsradius, oben</translation>
    </message>
    <message>
        <source>the wetted radius, bottom</source>
        <translation>des Benetzungsradius, unten</translation>
    </message>
    <message>
        <source>the run’s numbers at most</source>
        <translation>der Zahlen des Laufs höchstens</translation>
    </message>
    <message>
        <source>so no two cells lie at the same place</source>
        <translation>daher liegen keine zwei Zellen am selben Ort</translation>
    </message>
    <message>
        <source>its cells have %1 crossings across and the baseline’s %2</source>
        <translation>seine Zellen sind %1 Kreuzungen breit und die des Bezugs %2</translation>
    </message>
    <message>
        <source>its setts differ from the baseline’s, %1</source>
        <translation>seine Fadendichten weichen von denen des Bezugs ab, %1</translation>
    </message>
    <message>
        <source>its sample is of another size than the baseline’s, %1</source>
        <translation>seine Probe hat eine andere Größe als die des Bezugs, %1</translation>
    </message>
    <message>
        <source>The project has no fabric to begin with; add one.</source>
        <translation>Das Projekt hat kein Gewebe, mit dem man beginnen kann; fügen Sie eines hinzu.</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>The study has no fabric “%1”.</source>
        <translation>Die Studie hat kein Gewebe „%1“.</translation>
    </message>
    <message>
        <source>%1, study %2</source>
        <translation>%1, Studie %2</translation>
    </message>
    <message>
        <source>Added the fabric “%1”.</source>
        <translation>Das Gewebe „%1“ ist hinzugefügt.</translation>
    </message>
    <message>
        <source>These factors are no part of it: %1.</source>
        <translation>Diese Faktoren gehören nicht dazu: %1.</translation>
    </message>
    <message>
        <source>no run can be planned</source>
        <translation>es lässt sich kein Lauf planen</translation>
    </message>
    <message>
        <source>1 run</source>
        <translation>1 Lauf</translation>
    </message>
    <message>
        <source>%1 runs</source>
        <translation>%1 Läufe</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 Punkt</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1 (%2); time not known: %3.</source>
        <translation>%1 (%2); Dauer nicht bekannt: %3.</translation>
    </message>
    <message>
        <source>%1 (%2), %3, %4 at a time with %5 each.</source>
        <translation>%1 (%2), %3, %4 zugleich mit je %5.</translation>
    </message>
    <message>
        <source>cells of %1 × %2 mm, %3 × %4 crossings</source>
        <translation>Zellen von %1 × %2 mm, %3 × %4 Kreuzungspunkte</translation>
    </message>
    <message>
        <source>shown in sums of %1 × %2 cells</source>
        <translation>in Summen von %1 × %2 Zellen gezeigt</translation>
    </message>
    <message>
        <source>shown in sums of %1 × %2 cells at most</source>
        <translation>in Summen von höchstens %1 × %2 Zellen gezeigt</translation>
    </message>
    <message>
        <source>Hygroloom: left turns, middle moves</source>
        <translation>Hygroloom: links dreht, Mitte verschiebt</translation>
    </message>
    <message>
        <source>Blender: middle turns, Shift and middle moves</source>
        <translation>Blender: Mitte dreht, Umschalt und Mitte verschiebt</translation>
    </message>
    <message>
        <source>FreeCAD: middle moves, middle and left turns</source>
        <translation>FreeCAD: Mitte verschiebt, Mitte und links dreht</translation>
    </message>
    <message>
        <source>CLO: right turns, middle moves</source>
        <translation>CLO: rechts dreht, Mitte verschiebt</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation>Cividis</translation>
    </message>
    <message>
        <source>Natural: wet yarns darken (maps stay blue)</source>
        <translation>Natürlich: nasse Garne werden dunkler (Karten bleiben blau)</translation>
    </message>
    <message>
        <source>%1 in full.</source>
        <translation>%1 ungerundet.</translation>
    </message>
    <message>
        <source>%1 (not usable)</source>
        <translation>%1 (nicht nutzbar)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Hygroloom</source>
        <translation>Hygroloom</translation>
    </message>
    <message>
        <source>The film is being written.</source>
        <translation>Der Film wird geschrieben.</translation>
    </message>
    <message>
        <source>&amp;Leave without It</source>
        <translation>&amp;Ohne ihn gehen</translation>
    </message>
    <message>
        <source>Saving the film</source>
        <translation>Film wird gespeichert</translation>
    </message>
    <message>
        <source>Shorter is better.</source>
        <translation>Kürzer ist besser.</translation>
    </message>
    <message>
        <source>Longer is better.</source>
        <translation>Länger ist besser.</translation>
    </message>
    <message>
        <source>Lower is better.</source>
        <translation>Niedriger ist besser.</translation>
    </message>
    <message>
        <source>Higher is better.</source>
        <translation>Höher ist besser.</translation>
    </message>
    <message>
        <source>The run needs more memory than is free</source>
        <translation>Der Lauf braucht mehr Speicher, als frei ist</translation>
    </message>
    <message>
        <source>Without enough memory the computer becomes slow, or ends the program; what is not saved is lost then.</source>
        <translation>Ohne genug Speicher wird der Rechner langsam, oder er beendet das Programm; was nicht gespeichert ist, geht dann verloren.</translation>
    </message>
    <message>
        <source>&amp;Run All the Same</source>
        <translation>&amp;Trotzdem starten</translation>
    </message>
    <message>
        <source>The run was stopped</source>
        <translation>Der Lauf wurde gestoppt</translation>
    </message>
    <message>
        <source>Keep what it recorded?</source>
        <translation>Behalten, was er aufgezeichnet hat?</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>Beha&amp;lten</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>This run takes most of the memory that is free. Other programs may slow down.</source>
        <translation>Dieser Lauf belegt den größten Teil des freien Speichers. Andere Programme werden vielleicht langsamer.</translation>
    </message>
    <message>
        <source>The recording takes %1 on the disk. If you discard it, its results leave the screen.</source>
        <translation>Die Aufzeichnung belegt %1 auf dem Datenträger. Wenn Sie sie verwerfen, gehen ihre Ergebnisse vom Bildschirm.</translation>
    </message>
    <message>
        <source>The study leaves the garment as it is cut, so that no one fabric made this row. Tick fabrics in the study to take one along.</source>
        <translation>Die Studie lässt das Kleidungsstück, wie es geschnitten ist; diese Zeile hat deshalb nicht ein Gewebe. Kreuzen Sie in der Studie Gewebe an, um eines zu übernehmen.</translation>
    </message>
    <message>
        <source>%1 %2, %3; %4 on two cores.</source>
        <translation>%1 %2, %3; %4 auf zwei Kernen.</translation>
    </message>
    <message>
        <source>%1 %2, %3; %4 on this machine.</source>
        <translation>%1 %2, %3; %4 auf diesem Rechner.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>This run takes about %1 of memory; %2 are free.</source>
        <translation>Dieser Lauf belegt etwa %1 Speicher; %2 sind frei.</translation>
    </message>
</context>
<context>
    <name>hygroloom::CalibrateDialog</name>
    <message>
        <source>Contact angle</source>
        <translation>Randwinkel</translation>
    </message>
    <message>
        <source>Receding angle</source>
        <translation>Rückzugswinkel</translation>
    </message>
    <message>
        <source>Packing factor</source>
        <translation>Packungsdichte</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Anwenden</translation>
    </message>
    <message>
        <source>&amp;Save Report…</source>
        <translation>Bericht s&amp;peichern…</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message numerus="yes">
        <source>%n runs done</source>
        <translation>
            <numerusform>%n Lauf fertig</numerusform>
            <numerusform>%n Läufe fertig</numerusform>
        </translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>&amp;Experiment</source>
        <translation>&amp;Versuch</translation>
    </message>
    <message>
        <source>CSV: time_s and a series such as wick_height_mm, or a table of metrics</source>
        <translation>CSV: time_s und eine Reihe wie wick_height_mm, oder eine Tabelle von Kennzahlen</translation>
    </message>
    <message>
        <source>Measured file</source>
        <translation>Messdatei</translation>
    </message>
    <message>
        <source>&amp;Measured</source>
        <translation>&amp;Gemessen</translation>
    </message>
    <message>
        <source>%1: now %2, from %3 to %4</source>
        <translation>%1: jetzt %2, von %3 bis %4</translation>
    </message>
    <message>
        <source>%1: known</source>
        <translation>%1: bekannt</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Fidelity</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>F&amp;idelity</source>
        <translation>Genau&amp;igkeit</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>fitted, 90 %</source>
        <translation>angepasst, 90 %</translation>
    </message>
    <message>
        <source>range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Fitted inputs</source>
        <translation>Angepasste Eingaben</translation>
    </message>
    <message>
        <source>Result of the calibration</source>
        <translation>Ergebnis der Kalibrierung</translation>
    </message>
    <message>
        <source>Progress of the runs</source>
        <translation>Fortschritt der Läufe</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Measured File</source>
        <translation>Messdatei</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tabellen (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The project needs a fabric and an experiment.</source>
        <translation>Das Projekt braucht ein Gewebe und einen Versuch.</translation>
    </message>
    <message>
        <source>The project has errors; correct them first.</source>
        <translation>Das Projekt hat Fehler; beheben Sie zuerst diese.</translation>
    </message>
    <message>
        <source>Choose a file of what was measured.</source>
        <translation>Wählen Sie eine Datei mit Messwerten.</translation>
    </message>
    <message>
        <source>Tick what is to be fitted.</source>
        <translation>Kreuzen Sie an, was angepasst werden soll.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Residual: %1 before, %2 after, %3.</source>
        <translation>Rest: vorher %1, nachher %2, %3.</translation>
    </message>
    <message>
        <source>in spreads</source>
        <translation>in Streuungen</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
</context>
<context>
    <name>hygroloom::CalibrationRun</name>
    <message>
        <source>Not enough memory for these runs. Choose a smaller sample or a lower fidelity.</source>
        <translation>Der Speicher reicht für diese Läufe nicht. Wählen Sie eine kleinere Probe oder eine geringere Genauigkeit.</translation>
    </message>
    <message>
        <source>Calibration of %1</source>
        <translation>Kalibrierung von %1</translation>
    </message>
</context>
<context>
    <name>hygroloom::CandidateTable</name>
    <message>
        <source>Numbers of the candidates</source>
        <translation>Zahlen der Kandidaten</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Rang</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>Bezug</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Click to rank and sort by this number.</source>
        <translation>Klicken ordnet nach dieser Zahl und vergibt den Rang nach ihr.</translation>
    </message>
    <message>
        <source>1 is best by the number that sorts the table, or the first one. “=”: this simulation cannot tell them apart.</source>
        <translation>1 ist der beste nach der Zahl, die die Tabelle ordnet, sonst nach der ersten. „=“: Diese Simulation kann sie nicht unterscheiden.</translation>
    </message>
    <message>
        <source>The others are compared with %1.</source>
        <translation>Die anderen werden mit %1 verglichen.</translation>
    </message>
    <message>
        <source>Click to compare the others with %1.</source>
        <translation>Klicken vergleicht die anderen mit %1.</translation>
    </message>
    <message>
        <source>%1 is the baseline</source>
        <translation>%1 ist der Bezug</translation>
    </message>
    <message>
        <source>Make %1 the baseline</source>
        <translation>%1 zum Bezug machen</translation>
    </message>
    <message>
        <source>%1. Tick two to four to see their maps and curves below.</source>
        <translation>%1. Kreuzen Sie zwei bis vier an, um unten ihre Karten und Kurven zu sehen.</translation>
    </message>
    <message>
        <source>Click to open the run.</source>
        <translation>Klicken öffnet den Lauf.</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>wird gelesen …</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>misslungen</translation>
    </message>
    <message>
        <source>not run</source>
        <translation>nicht gerechnet</translation>
    </message>
    <message>
        <source>Use as &amp;Baseline</source>
        <translation>Als &amp;Bezug nehmen</translation>
    </message>
    <message>
        <source>&amp;Open This Run</source>
        <translation>Diesen Lauf ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Run What Is Missing</source>
        <translation>&amp;Fehlendes rechnen</translation>
    </message>
    <message>
        <source>outdated</source>
        <translation>überholt</translation>
    </message>
</context>
<context>
    <name>hygroloom::CandidatesPanel</name>
    <message>
        <source>one drop</source>
        <translation>ein Tropfen</translation>
    </message>
    <message>
        <source>This project has no fabric yet.
Add one to begin.</source>
        <translation>Dieses Projekt hat noch kein Gewebe.
Fügen Sie eines hinzu, um zu beginnen.</translation>
    </message>
    <message>
        <source>Fabrics of the project</source>
        <translation>Gewebe des Projekts</translation>
    </message>
    <message>
        <source>&amp;Add Fabric</source>
        <translation>Gewebe &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Add a plain-weave cotton fabric</source>
        <translation>Ein Baumwollgewebe in Leinwandbindung hinzufügen</translation>
    </message>
    <message>
        <source>D&amp;uplicate Fabric</source>
        <translation>Gewebe &amp;duplizieren</translation>
    </message>
    <message>
        <source>Add a copy of the selected fabric</source>
        <translation>Eine Kopie des gewählten Gewebes hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Rename Fabric</source>
        <translation>Gewebe &amp;umbenennen</translation>
    </message>
    <message>
        <source>Rename the selected fabric</source>
        <translation>Das gewählte Gewebe umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete Fabric</source>
        <translation>Gewebe &amp;löschen</translation>
    </message>
    <message>
        <source>Delete the selected fabric</source>
        <translation>Das gewählte Gewebe löschen</translation>
    </message>
    <message>
        <source>From &amp;Preset…</source>
        <translation>Aus &amp;Vorlage…</translation>
    </message>
    <message>
        <source>Add a fabric from the library</source>
        <translation>Ein Gewebe aus der Bibliothek hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Save to My Library</source>
        <translation>In meiner &amp;Bibliothek speichern</translation>
    </message>
    <message>
        <source>Save the selected fabric to my library</source>
        <translation>Das gewählte Gewebe in meiner Bibliothek speichern</translation>
    </message>
    <message>
        <source>%1: %2, %3 × %4 per cm</source>
        <translation>%1: %2, %3 × %4 je cm</translation>
    </message>
    <message>
        <source>free weave</source>
        <translation>freie Bindung</translation>
    </message>
    <message>
        <source>New fabric</source>
        <translation>Neues Gewebe</translation>
    </message>
    <message>
        <source>add fabric</source>
        <translation>Gewebe hinzufügen</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Saved %1 to my library.</source>
        <translation>%1 ist in meiner Bibliothek gespeichert.</translation>
    </message>
    <message>
        <source>duplicate fabric</source>
        <translation>Gewebe duplizieren</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 Kopie</translation>
    </message>
    <message>
        <source>delete fabric</source>
        <translation>Gewebe löschen</translation>
    </message>
    <message>
        <source>rename fabric</source>
        <translation>Gewebe umbenennen</translation>
    </message>
</context>
<context>
    <name>hygroloom::CardDialog</name>
    <message>
        <source>&amp;Save Card…</source>
        <translation>Karte &amp;speichern…</translation>
    </message>
    <message>
        <source>Technical Card</source>
        <translation>Technische Karte</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>Norm</translation>
    </message>
    <message>
        <source>run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Numbers of the card</source>
        <translation>Zahlen der Karte</translation>
    </message>
    <message>
        <source>Progress of the runs</source>
        <translation>Fortschritt der Läufe</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Runs absorbency, wicking, moisture management, drying and regain at the fidelity live, in the background. Takes a minute or two.</source>
        <translation>Führt Aufnahme, Saugen, Feuchtemanagement, Trocknen und Feuchteaufnahme mit der Genauigkeit „live“ im Hintergrund aus. Das dauert ein bis zwei Minuten.</translation>
    </message>
    <message>
        <source>The project has no fabric.</source>
        <translation>Das Projekt hat kein Gewebe.</translation>
    </message>
    <message>
        <source>The fabric has errors; see Issues. Mend them first.</source>
        <translation>Das Gewebe hat Fehler; siehe Meldungen. Beheben Sie diese zuerst.</translation>
    </message>
    <message>
        <source>The numbers are being computed.</source>
        <translation>Die Zahlen werden berechnet.</translation>
    </message>
    <message>
        <source>Numbers in grey need runs.</source>
        <translation>Graue Zahlen brauchen Läufe.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>&amp;Run the Tests</source>
        <translation>Prüfungen aus&amp;führen</translation>
    </message>
    <message>
        <source>(grade %1)</source>
        <translation>(Note %1)</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Notes of the card</source>
        <translation>Anmerkungen der Karte</translation>
    </message>
    <message>
        <source>The tests are paused. The queue of runs, below in the main window, lets them go on.</source>
        <translation>Die Prüfungen sind angehalten. Die Warteschlange der Läufe, unten im Hauptfenster, lässt sie weitergehen.</translation>
    </message>
    <message>
        <source>Tests are in progress</source>
        <translation>Prüfungen laufen</translation>
    </message>
    <message>
        <source>Stop the tests of the technical card?</source>
        <translation>Die Prüfungen der technischen Karte stoppen?</translation>
    </message>
    <message>
        <source>Numbers of tests that have ended are lost, too, unless the card is saved.</source>
        <translation>Auch die Zahlen beendeter Prüfungen gehen verloren, wenn die Karte nicht gespeichert ist.</translation>
    </message>
    <message>
        <source>Stop the Tests</source>
        <translation>Prüfungen stoppen</translation>
    </message>
</context>
<context>
    <name>hygroloom::CardExport</name>
    <message>
        <source>Another card is still being written. Save this one when that is done.</source>
        <translation>Eine andere Karte wird noch geschrieben. Speichern Sie diese, wenn jene fertig ist.</translation>
    </message>
    <message>
        <source>%1, card</source>
        <translation>%1, Karte</translation>
    </message>
    <message>
        <source>Making the card.</source>
        <translation>Die Karte wird erstellt.</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Save Card</source>
        <translation>Karte speichern</translation>
    </message>
</context>
<context>
    <name>hygroloom::CardNumbers</name>
    <message>
        <source>Not enough memory for the tests of the card.</source>
        <translation>Für die Prüfungen der Karte reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>The tests of the technical card of %1 were stopped: the fabric is another now.</source>
        <translation>Die Prüfungen der technischen Karte von %1 wurden gestoppt: Das Gewebe ist jetzt ein anderes.</translation>
    </message>
</context>
<context>
    <name>hygroloom::Chart</name>
    <message>
        <source>%1: %2 %3 at %4 s</source>
        <translation>%1: %2 %3 bei %4 s</translation>
    </message>
</context>
<context>
    <name>hygroloom::ClimateCourse</name>
    <message>
        <source>Climate over time</source>
        <translation>Klimaverlauf</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Temp.</source>
        <translation>Temp.</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>Feuchte</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Time from the start of the experiment</source>
        <translation>Zeit ab Beginn des Versuchs</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Relative humidity</source>
        <translation>Relative Luftfeuchte</translation>
    </message>
    <message>
        <source>Air speed</source>
        <translation>Luftgeschwindigkeit</translation>
    </message>
    <message>
        <source>Add a time</source>
        <translation>Eine Zeit hinzufügen</translation>
    </message>
    <message>
        <source>Remove the selected time</source>
        <translation>Die gewählte Zeit entfernen</translation>
    </message>
    <message>
        <source>About the climate over time</source>
        <translation>Über den Klimaverlauf</translation>
    </message>
    <message>
        <source>Row %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>The climate changes linearly between these times and is constant after the last.</source>
        <translation>Das Klima ändert sich zwischen diesen Zeiten linear und bleibt nach der letzten gleich.</translation>
    </message>
    <message>
        <source>The climate is constant. Add a time to change it.</source>
        <translation>Das Klima bleibt gleich. Fügen Sie eine Zeit hinzu, um es zu ändern.</translation>
    </message>
    <message>
        <source>climate over time</source>
        <translation>Klimaverlauf</translation>
    </message>
    <message>
        <source>add climate time</source>
        <translation>Zeit des Klimas hinzufügen</translation>
    </message>
    <message>
        <source>remove climate time</source>
        <translation>Zeit des Klimas entfernen</translation>
    </message>
</context>
<context>
    <name>hygroloom::ClothChoice</name>
    <message>
        <source>Cloths on the Table</source>
        <translation>Stoffe auf dem Tisch</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Stoffe</translation>
    </message>
    <message>
        <source>Tick %1 to %2 fabrics (%3 ticked).</source>
        <translation>Wählen Sie %1 bis %2 Stoffe (%3 gewählt).</translation>
    </message>
    <message>
        <source>%1 (drops do not stand on it)</source>
        <translation>%1 (Tropfen stehen nicht darauf)</translation>
    </message>
</context>
<context>
    <name>hygroloom::ClothsView</name>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Time of all cloths</source>
        <translation>Zeit aller Gewebe</translation>
    </message>
    <message>
        <source>%1 in 3D</source>
        <translation>%1 in 3D</translation>
    </message>
</context>
<context>
    <name>hygroloom::ClusterDialog</name>
    <message>
        <source>One &amp;GPU for each task</source>
        <translation>Eine &amp;GPU je Aufgabe</translation>
    </message>
    <message>
        <source>&amp;Write the Folder</source>
        <translation>Ordner &amp;schreiben</translation>
    </message>
    <message>
        <source>&amp;Submit Here</source>
        <translation>Von &amp;hier abschicken</translation>
    </message>
    <message>
        <source>Study for a Cluster</source>
        <translation>Studie für einen Cluster</translation>
    </message>
    <message>
        <source>Options for sbatch</source>
        <translation>Optionen für sbatch</translation>
    </message>
    <message>
        <source>16 runs each</source>
        <translation>je 16 Läufe</translation>
    </message>
    <message>
        <source>Tasks of the job array</source>
        <translation>Aufgaben des Job-Arrays</translation>
    </message>
    <message>
        <source>What to type on the cluster</source>
        <translation>Was auf dem Cluster einzugeben ist</translation>
    </message>
    <message>
        <source>The folder receives the project and the study. It must be on a disk that all machines of the cluster have, or be copied there. Then type on the cluster:</source>
        <translation>Der Ordner erhält das Projekt und die Studie. Er muss auf einem Datenträger liegen, den alle Rechner des Clusters haben, oder dorthin kopiert werden. Geben Sie dann auf dem Cluster ein:</translation>
    </message>
    <message>
        <source>Folder:</source>
        <translation>Ordner:</translation>
    </message>
    <message>
        <source>Options for sbatch:</source>
        <translation>Optionen für sbatch:</translation>
    </message>
    <message>
        <source>Tasks:</source>
        <translation>Aufgaben:</translation>
    </message>
    <message>
        <source>&amp;Copy the Commands</source>
        <translation>Befehle &amp;kopieren</translation>
    </message>
    <message>
        <source>Write the folder and submit the job array.</source>
        <translation>Den Ordner schreiben und das Job-Array abschicken.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>In %1 geschrieben.</translation>
    </message>
    <message>
        <source>Submitted job %1 with %2 tasks.</source>
        <translation>Job %1 mit %2 Aufgaben abgeschickt.</translation>
    </message>
</context>
<context>
    <name>hygroloom::ColorRanges</name>
    <message>
        <source>%1, kept ▲</source>
        <translation>%1, fest ▲</translation>
    </message>
    <message>
        <source>%1, kept</source>
        <translation>%1, fest</translation>
    </message>
</context>
<context>
    <name>hygroloom::CommandPalette</name>
    <message>
        <source>No command matches.</source>
        <translation>Kein Befehl passt.</translation>
    </message>
    <message>
        <source>Find Command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Words of the command</source>
        <translation>Wörter des Befehls</translation>
    </message>
    <message>
        <source>Type letters of a command</source>
        <translation>Buchstaben eines Befehls eingeben</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>hygroloom::CompareBar</name>
    <message>
        <source>&amp;Run All Missing</source>
        <translation>Alle &amp;fehlenden rechnen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>&amp;Measured…</source>
        <translation>Ge&amp;messenes…</translation>
    </message>
    <message>
        <source>Save &amp;Table…</source>
        <translation>&amp;Tabelle speichern…</translation>
    </message>
    <message>
        <source>Save Re&amp;port…</source>
        <translation>Be&amp;richt speichern…</translation>
    </message>
    <message>
        <source>Progress of the runs</source>
        <translation>Fortschritt der Läufe</translation>
    </message>
    <message>
        <source>Missing runs</source>
        <translation>Fehlende Läufe</translation>
    </message>
    <message>
        <source>E&amp;xperiment:</source>
        <translation>Versu&amp;ch:</translation>
    </message>
    <message>
        <source>F&amp;idelity:</source>
        <translation>Genau&amp;igkeit:</translation>
    </message>
    <message>
        <source>R&amp;eplicates:</source>
        <translation>&amp;Wiederholungen:</translation>
    </message>
    <message>
        <source>Filter fabrics</source>
        <translation>Gewebe filtern</translation>
    </message>
    <message>
        <source>Put a laboratory&apos;s numbers beside the simulated ones, from a CSV file with the columns fabric, metric, value, unit and, if known, spread.</source>
        <translation>Stellt die Zahlen eines Labors neben die simulierten, aus einer CSV-Datei mit den Spalten fabric, metric, value, unit und, wenn bekannt, spread.</translation>
    </message>
    <message>
        <source>Write the numbers as a CSV file for spreadsheets.</source>
        <translation>Schreibt die Zahlen als CSV-Datei für Tabellenprogramme.</translation>
    </message>
    <message>
        <source>Write verdicts, intervals, maps, curves, and what is not known, as PDF or web page.</source>
        <translation>Schreibt Urteile, Intervalle, Karten, Kurven und was nicht bekannt ist als PDF oder Webseite.</translation>
    </message>
    <message>
        <source>Cannot run: %1</source>
        <translation>Lässt sich nicht rechnen: %1</translation>
    </message>
    <message>
        <source>Nothing is missing.</source>
        <translation>Nichts fehlt.</translation>
    </message>
    <message>
        <source>1 run</source>
        <translation>1 Lauf</translation>
    </message>
    <message>
        <source>%1 runs</source>
        <translation>%1 Läufe</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Run each fabric that has no run of this experiment yet.</source>
        <translation>Rechnet jedes Gewebe, das noch keinen Lauf dieses Versuchs hat.</translation>
    </message>
    <message>
        <source>Choose one experiment, and run it on two fabrics at least.</source>
        <translation>Wählen Sie einen Versuch, und lassen Sie ihn mit mindestens zwei Stoffen laufen.</translation>
    </message>
    <message>
        <source>Choose one experiment, and run it on a fabric.</source>
        <translation>Wählen Sie einen Versuch, und lassen Sie ihn mit einem Stoff laufen.</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>wird gelesen …</translation>
    </message>
    <message>
        <source>Runs of each fabric. With more than one, all but the first have inputs drawn within what is not known of the cloth; intervals then hold this scatter.</source>
        <translation>Läufe jedes Stoffes. Bei mehreren werden in allen bis auf den ersten die Eingaben in den Grenzen dessen gezogen, was man vom Stoff nicht weiß; die Intervalle enthalten dann diese Streuung.</translation>
    </message>
    <message>
        <source>Part of the garment</source>
        <translation>Teil des Kleidungsstücks</translation>
    </message>
    <message>
        <source>Card &amp;Numbers</source>
        <translation>Karten&amp;zahlen</translation>
    </message>
    <message>
        <source>Numbers of the technical card as columns: air, heat and vapour, water held, cost. They need no run.</source>
        <translation>Zahlen der technischen Karte als Spalten: Luft, Wärme und Dampf, gehaltenes Wasser, Kosten. Sie brauchen keinen Lauf.</translation>
    </message>
</context>
<context>
    <name>hygroloom::CompareMaps</name>
    <message>
        <source>Maps</source>
        <translation>Karten</translation>
    </message>
    <message>
        <source>Difference to baseline</source>
        <translation>Unterschied zum Bezug</translation>
    </message>
    <message>
        <source>What the maps show</source>
        <translation>Was die Karten zeigen</translation>
    </message>
    <message>
        <source>Top face</source>
        <translation>Oberseite</translation>
    </message>
    <message>
        <source>Bottom face</source>
        <translation>Unterseite</translation>
    </message>
    <message>
        <source>Face of the fabrics</source>
        <translation>Seite der Gewebe</translation>
    </message>
    <message>
        <source>Time of all maps</source>
        <translation>Zeit aller Karten</translation>
    </message>
    <message>
        <source>Value under the pointer</source>
        <translation>Wert unter dem Zeiger</translation>
    </message>
    <message>
        <source>Water on %1</source>
        <translation>Wasser auf %1</translation>
    </message>
    <message>
        <source>There is no difference map of %1: %2.</source>
        <translation>Von %1 gibt es keine Differenzkarte: %2.</translation>
    </message>
    <message>
        <source>Tick a second fabric to see how it differs.</source>
        <translation>Kreuzen Sie ein zweites Gewebe an, um zu sehen, wie es sich unterscheidet.</translation>
    </message>
    <message>
        <source>Water less that of %1.</source>
        <translation>Wasser abzüglich dessen von %1.</translation>
    </message>
    <message>
        <source>a numerical error of %1 %</source>
        <translation>einem numerischen Fehler von %1 %</translation>
    </message>
    <message>
        <source>no numerical error, which is not known</source>
        <translation>keinem numerischen Fehler, denn er ist nicht bekannt</translation>
    </message>
    <message>
        <source>%1 Grey: the difference is at most %2 % of the wetter one, the numerical error of %3.</source>
        <translation>%1 Grau: Der Unterschied ist höchstens %2 % des nasseren, der numerische Fehler %3.</translation>
    </message>
    <message>
        <source>%1 The numerical error of these runs is not known: grey cells are exactly equal.</source>
        <translation>%1 Der numerische Fehler dieser Läufe ist nicht bekannt: Graue Zellen sind genau gleich.</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>g/m²</source>
        <translation>g/m²</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>Each cloth as given. Under the pointer also the range of its replicates, of larger cells.</source>
        <translation>Jeder Stoff wie angegeben. Unter dem Zeiger auch der Bereich seiner Wiederholungen, in größeren Zellen.</translation>
    </message>
    <message>
        <source>One run each of %1 and the baseline, of whose replicates fewer than two pairs keep maps: grey is the numerical error alone.</source>
        <translation>Je ein Lauf von %1 und vom Bezug, von deren Wiederholungen weniger als zwei Paare Karten haben: Grau ist nur der numerische Fehler.</translation>
    </message>
    <message>
        <source>%1 Mean of at least %2 pairs of replicates after %3, the nearest time of which they keep maps. Grey: the interval of the mean difference, with %4, holds 0.</source>
        <translation>%1 Mittel aus mindestens %2 Paaren von Wiederholungen nach %3, dem nächsten Zeitpunkt, für den sie Karten haben. Grau: Das Intervall der mittleren Differenz, mit %4, enthält 0.</translation>
    </message>
    <message>
        <source>%1 The numerical error of %2 is not known: grey cells are exactly equal.</source>
        <translation>%1 Der numerische Fehler von %2 ist nicht bekannt: Graue Zellen sind genau gleich.</translation>
    </message>
    <message>
        <source>%1 That of %2 is not known: grey cells are exactly equal there.</source>
        <translation>%1 Der von %2 ist nicht bekannt: Graue Zellen sind dort genau gleich.</translation>
    </message>
</context>
<context>
    <name>hygroloom::CompareView</name>
    <message>
        <source>Candidates</source>
        <translation>Kandidaten</translation>
    </message>
    <message>
        <source>All Runs</source>
        <translation>Alle Läufe</translation>
    </message>
    <message>
        <source>Maps</source>
        <translation>Karten</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Fingerabdruck</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Streudiagramm</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>At most four runs can be compared.</source>
        <translation>Höchstens vier Läufe lassen sich vergleichen.</translation>
    </message>
    <message>
        <source>All experiments</source>
        <translation>Alle Versuche</translation>
    </message>
    <message>
        <source>%1, of other runs</source>
        <translation>%1, anderer Läufe</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Enter or the button runs it.</source>
        <translation>Die Eingabetaste oder der Knopf rechnet es.</translation>
    </message>
    <message>
        <source>running…</source>
        <translation>rechnet …</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>This project has no fabric. Add one with Fabric ▸ Add Fabric.</source>
        <translation>Dieses Projekt hat kein Gewebe. Fügen Sie eines mit Gewebe ▸ Gewebe hinzufügen hinzu.</translation>
    </message>
    <message>
        <source>This project has no experiment. Add one with Experiment ▸ Add Experiment.</source>
        <translation>Dieses Projekt hat keinen Versuch. Fügen Sie einen mit Versuch ▸ Versuch hinzufügen hinzu.</translation>
    </message>
    <message>
        <source>A comparison needs a second fabric: add one with Fabric ▸ Add Fabric, or tick an older run under All Runs.</source>
        <translation>Ein Vergleich braucht ein zweites Gewebe: Fügen Sie eines mit Gewebe ▸ Gewebe hinzufügen hinzu oder kreuzen Sie unter Alle Läufe einen älteren Lauf an.</translation>
    </message>
    <message>
        <source>%1 as given</source>
        <translation>%1 wie angegeben</translation>
    </message>
    <message>
        <source>%1 as is typical</source>
        <translation>%1 wie üblich</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>These runs have different fidelities, which is part of their difference.</source>
        <translation>Diese Läufe haben verschiedene Genauigkeiten, was zu ihrem Unterschied beiträgt.</translation>
    </message>
    <message>
        <source>Tick two to four fabrics above to see them side by side.</source>
        <translation>Kreuzen Sie oben zwei bis vier Gewebe an, um sie nebeneinander zu sehen.</translation>
    </message>
    <message>
        <source>Nothing has been run yet. “Run All Missing” above runs the experiment on every fabric. Recordings that are opened stand under All Runs.</source>
        <translation>Noch ist nichts gerechnet. „Alle fehlenden rechnen“ oben rechnet den Versuch mit jedem Gewebe. Geöffnete Aufzeichnungen stehen unter Alle Läufe.</translation>
    </message>
    <message>
        <source>Choose one experiment above to see its maps and curves.</source>
        <translation>Wählen Sie oben einen Versuch, um seine Karten und Kurven zu sehen.</translation>
    </message>
    <message>
        <source>Nothing can be run: %1</source>
        <translation>Nichts lässt sich rechnen: %1</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Another report is still being written. Save this one when that is done.</source>
        <translation>Ein anderer Bericht wird noch geschrieben. Speichern Sie diesen, wenn jener fertig ist.</translation>
    </message>
    <message>
        <source>Measured Numbers</source>
        <translation>Gemessene Zahlen</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tabellen (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Runs are in progress</source>
        <translation>Läufe sind im Gang</translation>
    </message>
    <message>
        <source>Stop the runs of Compare?</source>
        <translation>Die Läufe des Vergleichs stoppen?</translation>
    </message>
    <message>
        <source>%1. Those are kept with the project.</source>
        <translation>%1. Diese bleiben beim Projekt.</translation>
    </message>
    <message>
        <source>Stop the Runs</source>
        <translation>Läufe stoppen</translation>
    </message>
    <message>
        <source>Water reached the edge of the sample in: %1. A larger sample changes these numbers.</source>
        <translation>Wasser hat den Rand der Probe erreicht bei: %1. Eine größere Probe ändert diese Zahlen.</translation>
    </message>
    <message>
        <source>%1 replicates of these runs are kept. Choose more than one under Replicates to judge by them.</source>
        <translation>%1 Wiederholungen dieser Läufe sind da. Wählen Sie unter Wiederholungen mehr als eine, um nach ihnen zu urteilen.</translation>
    </message>
    <message>
        <source>The runs of this project are being read.</source>
        <translation>Die Läufe dieses Projekts werden gelesen.</translation>
    </message>
    <message>
        <source>fidelity %1</source>
        <translation>Genauigkeit %1</translation>
    </message>
    <message>
        <source>earlier run</source>
        <translation>früherer Lauf</translation>
    </message>
    <message>
        <source>other run: %1</source>
        <translation>anderer Lauf: %1</translation>
    </message>
    <message>
        <source>Since this was run, these have changed: %1.</source>
        <translation>Seit diesem Lauf wurde geändert: %1.</translation>
    </message>
    <message>
        <source>Maps and 3D are of the first replicate; curves and difference maps are of all of them, whose yarns are uneven: %1.</source>
        <translation>Karten und 3D zeigen die erste Wiederholung; Kurven und Differenzkarten zeigen alle, deren Garne ungleichmäßig sind: %1.</translation>
    </message>
    <message>
        <source>The verdicts rest on the numerical error of one run of each cloth. Other pieces of the same cloths may come in another order: choose 8 replicates to judge by them.</source>
        <translation>Die Urteile beruhen auf dem numerischen Fehler eines Laufs je Gewebe. Andere Stücke derselben Gewebe können in anderer Reihenfolge liegen: Wählen Sie 8 Wiederholungen, um danach zu urteilen.</translation>
    </message>
    <message>
        <source>whole garment</source>
        <translation>ganzes Kleidungsstück</translation>
    </message>
    <message>
        <source>Maps are of the first replicate; curves are of all of them.</source>
        <translation>Karten gelten für die erste Wiederholung, Kurven für alle.</translation>
    </message>
    <message>
        <source>One run of each garment shows no scatter, so there is no verdict: choose 4 replicates or more to judge by them.</source>
        <translation>Ein Lauf je Kleidungsstück zeigt keine Streuung, deshalb gibt es kein Urteil: Wählen Sie 4 oder mehr Wiederholungen, um nach ihnen zu urteilen.</translation>
    </message>
    <message>
        <source>Outdated, as the design or the program has changed since they were run: %1. “Run All Missing” runs them again. The older runs stand under All Runs.</source>
        <translation>Überholt, weil der Entwurf oder das Programm nach dem Lauf geändert wurde: %1. „Alle fehlenden rechnen“ rechnet sie neu. Die älteren Läufe stehen unter Alle Läufe.</translation>
    </message>
</context>
<context>
    <name>hygroloom::CountEdit</name>
    <message>
        <source>“%1” is no yarn count: %2. Write it as %3.</source>
        <translation>„%1“ ist keine Garnfeinheit: %2. Schreiben Sie %3.</translation>
    </message>
</context>
<context>
    <name>hygroloom::CurveLegend</name>
    <message>
        <source>Curves: %1</source>
        <translation>Kurven: %1</translation>
    </message>
</context>
<context>
    <name>hygroloom::CurvesView</name>
    <message>
        <source>%1: %2 %3 at %4 s</source>
        <translation>%1: %2 %3 bei %4 s</translation>
    </message>
    <message>
        <source>numerical error</source>
        <translation>numerischer Fehler</translation>
    </message>
    <message>
        <source>%1 (%2: %3 to %4)</source>
        <translation>%1 (%2: %3 bis %4)</translation>
    </message>
    <message>
        <source>What the bands are</source>
        <translation>Was die Bänder sind</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Value under the pointer</source>
        <translation>Wert unter dem Zeiger</translation>
    </message>
    <message>
        <source>Curves of the ticked runs</source>
        <translation>Kurven der angekreuzten Läufe</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>With replicates the line is their middle, and the band goes from the least to the most of them; of %1 and more, from the 5th to the 95th percentile.</source>
        <translation>Bei Wiederholungen ist die Linie ihre Mitte, und das Band reicht von der kleinsten bis zur größten; ab %1 vom 5. bis zum 95. Perzentil.</translation>
    </message>
    <message>
        <source>Band: the numerical error of %1, as measured on runs of this kind.</source>
        <translation>Band: der numerische Fehler %1, gemessen an Läufen dieser Art.</translation>
    </message>
    <message>
        <source>No numerical error of this curve is known, so there is no band.</source>
        <translation>Von dieser Kurve ist kein numerischer Fehler bekannt, daher gibt es kein Band.</translation>
    </message>
    <message>
        <source>Of %1 the cloth as given is drawn, with its numerical error where that is known.</source>
        <translation>Von %1 ist das Gewebe wie angegeben gezeichnet, mit seinem numerischen Fehler, wo er bekannt ist.</translation>
    </message>
    <message>
        <source>Of %1 some replicates were computed by a version that kept no curves, or are too old: they are not in the band.</source>
        <translation>Von %1 wurden manche Wiederholungen von einer Version gerechnet, die keine Kurven behielt, oder sind zu alt: Sie sind nicht im Band.</translation>
    </message>
    <message>
        <source>Tick two to four fabrics above to see their curves over each other.</source>
        <translation>Kreuzen Sie oben zwei bis vier Gewebe an, um ihre Kurven übereinander zu sehen.</translation>
    </message>
</context>
<context>
    <name>hygroloom::DesignForm</name>
    <message>
        <source>Show or hide these fields.</source>
        <translation>Diese Felder zeigen oder verbergen.</translation>
    </message>
    <message>
        <source>The same in other units</source>
        <translation>Dasselbe in anderen Einheiten</translation>
    </message>
</context>
<context>
    <name>hygroloom::DesignWorkspace</name>
    <message>
        <source>Candidates</source>
        <translation>Kandidaten</translation>
    </message>
    <message>
        <source>Weave</source>
        <translation>Bindung</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Webbrief</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Water, live</source>
        <translation>Wasser, live</translation>
    </message>
    <message>
        <source>Edit this value of “%1” in the project file, under “materials”.</source>
        <translation>Ändern Sie diesen Wert von „%1“ in der Projektdatei unter „materials“.</translation>
    </message>
</context>
<context>
    <name>hygroloom::Document</name>
    <message>
        <source>Example: %1</source>
        <translation>Beispiel: %1</translation>
    </message>
</context>
<context>
    <name>hygroloom::DraftEditor</name>
    <message>
        <source>Shafts</source>
        <translation>Schäfte</translation>
    </message>
    <message>
        <source>Treadles</source>
        <translation>Tritte</translation>
    </message>
    <message>
        <source>Find Draft</source>
        <translation>Webbrief finden</translation>
    </message>
    <message>
        <source>Find the draft of this weave with the fewest shafts and treadles.</source>
        <translation>Findet den Webbrief dieser Bindung mit den wenigsten Schäften und Tritten.</translation>
    </message>
    <message>
        <source>About the draft</source>
        <translation>Über den Webbrief</translation>
    </message>
    <message>
        <source>Show the cloth in the colours of its yarns</source>
        <translation>Das Gewebe in den Farben seiner Garne zeigen</translation>
    </message>
    <message>
        <source>Zoom into the draft</source>
        <translation>Webbrief vergrößern</translation>
    </message>
    <message>
        <source>Zoom out of the draft</source>
        <translation>Webbrief verkleinern</translation>
    </message>
    <message>
        <source>Treadling or liftplan</source>
        <translation>Trittfolge oder Hebeplan</translation>
    </message>
    <message>
        <source>Tie-up and treadling</source>
        <translation>Schnürung und Trittfolge</translation>
    </message>
    <message>
        <source>Liftplan</source>
        <translation>Hebeplan</translation>
    </message>
    <message>
        <source>A treadle lifts the shafts tied to it. A liftplan lists the shafts of each pick. Both weave the same cloth.</source>
        <translation>Ein Tritt hebt die an ihn geschnürten Schäfte. Ein Hebeplan nennt die Schäfte jedes Schusses. Beide weben dasselbe Gewebe.</translation>
    </message>
    <message>
        <source>Shed</source>
        <translation>Fach</translation>
    </message>
    <message>
        <source>Rising shed</source>
        <translation>Hochfach</translation>
    </message>
    <message>
        <source>Sinking shed</source>
        <translation>Tieffach</translation>
    </message>
    <message>
        <source>Whether the marked shafts rise or sink. The marks stay; the cloth turns over.</source>
        <translation>Ob die markierten Schäfte steigen oder sinken. Die Marken bleiben; das Gewebe wendet sich.</translation>
    </message>
    <message>
        <source>tie-up and treadling</source>
        <translation>Schnürung und Trittfolge</translation>
    </message>
    <message>
        <source>liftplan</source>
        <translation>Hebeplan</translation>
    </message>
    <message>
        <source>rising shed</source>
        <translation>Hochfach</translation>
    </message>
    <message>
        <source>sinking shed</source>
        <translation>Tieffach</translation>
    </message>
    <message>
        <source>The weave has no draft of its own; this is the smallest one. Change it here or press Find Draft to keep it.</source>
        <translation>Die Bindung hat keinen eigenen Webbrief; dies ist der kleinste. Ändern Sie ihn hier oder behalten Sie ihn mit Webbrief finden.</translation>
    </message>
    <message>
        <source>drawdown</source>
        <translation>Gewebebild</translation>
    </message>
    <message>
        <source>threading</source>
        <translation>Einzug</translation>
    </message>
    <message>
        <source>tie-up</source>
        <translation>Schnürung</translation>
    </message>
    <message>
        <source>order of the ends</source>
        <translation>Folge der Kettfäden</translation>
    </message>
    <message>
        <source>order of the picks</source>
        <translation>Folge der Schussfäden</translation>
    </message>
    <message>
        <source>treadling</source>
        <translation>Trittfolge</translation>
    </message>
    <message>
        <source>find draft</source>
        <translation>Webbrief finden</translation>
    </message>
    <message>
        <source>number of shafts</source>
        <translation>Zahl der Schäfte</translation>
    </message>
    <message>
        <source>number of treadles</source>
        <translation>Zahl der Tritte</translation>
    </message>
</context>
<context>
    <name>hygroloom::DraftPaper</name>
    <message>
        <source>Draft</source>
        <translation>Webbrief</translation>
    </message>
    <message>
        <source>Threading above, treadling on the right, tie-up in the corner, yarns along both edges. Click or drag to change; with Ctrl a second shaft or treadle is added. Arrow keys move, Space changes.</source>
        <translation>Einzug oben, Trittfolge rechts, Schnürung in der Ecke, Garne an beiden Rändern. Klicken oder ziehen ändert; mit Strg kommt ein zweiter Schaft oder Tritt dazu. Pfeiltasten bewegen, die Leertaste ändert.</translation>
    </message>
    <message>
        <source>Scroll along the picks</source>
        <translation>Entlang der Schüsse rollen</translation>
    </message>
    <message>
        <source>Scroll along the ends</source>
        <translation>Entlang der Kettfäden rollen</translation>
    </message>
</context>
<context>
    <name>hygroloom::DropletSection</name>
    <message>
        <source>Droplets</source>
        <translation>Tropfen</translation>
    </message>
    <message>
        <source>Add a droplet</source>
        <translation>Einen Tropfen hinzufügen</translation>
    </message>
    <message>
        <source>Remove the droplet</source>
        <translation>Den Tropfen entfernen</translation>
    </message>
    <message>
        <source>Place the droplet: click on the fabric</source>
        <translation>Den Tropfen setzen: auf das Gewebe klicken</translation>
    </message>
    <message>
        <source>No droplet yet. Add one to wet the fabric.</source>
        <translation>Noch kein Tropfen. Fügen Sie einen hinzu, um das Gewebe zu benetzen.</translation>
    </message>
    <message>
        <source>Position along weft</source>
        <translation>Ort in Schussrichtung</translation>
    </message>
    <message>
        <source>droplet position</source>
        <translation>Ort des Tropfens</translation>
    </message>
    <message>
        <source>Distance from the sample&apos;s centre.</source>
        <translation>Abstand von der Mitte der Probe.</translation>
    </message>
    <message>
        <source>Position along warp</source>
        <translation>Ort in Kettrichtung</translation>
    </message>
    <message>
        <source>add droplet</source>
        <translation>Tropfen hinzufügen</translation>
    </message>
    <message>
        <source>remove droplet</source>
        <translation>Tropfen entfernen</translation>
    </message>
    <message>
        <source>%1: %2 µl at %3 s, at (%4, %5) %6</source>
        <translation>%1: %2 µl bei %3 s, an (%4, %5) %6</translation>
    </message>
    <message>
        <source>droplet</source>
        <translation>Tropfen</translation>
    </message>
</context>
<context>
    <name>hygroloom::EffectsChart</name>
    <message>
        <source>Main effects of the factors</source>
        <translation>Haupteffekte der Faktoren</translation>
    </message>
    <message>
        <source>%1 %2: mean %3 ± %4 of %5, %6 rows</source>
        <translation>%1 %2: Mittel %3 ± %4 von %5, %6 Zeilen</translation>
    </message>
    <message>
        <source>%1 %2: %3 of %4, %5 row</source>
        <translation>%1 %2: %3 von %4, %5 Zeile</translation>
    </message>
</context>
<context>
    <name>hygroloom::EffectsView</name>
    <message>
        <source>Metric of the effects</source>
        <translation>Kennzahl der Effekte</translation>
    </message>
    <message>
        <source>Metric:</source>
        <translation>Kennzahl:</translation>
    </message>
    <message>
        <source>What the effects show</source>
        <translation>Was die Effekte zeigen</translation>
    </message>
    <message>
        <source>Points: the rows. Line, or large points where a factor has a few values: their mean, whatever the other factors are. Band and bars: where that mean lies, with 90 %.</source>
        <translation>Punkte: die Zeilen. Linie, oder große Punkte, wo ein Faktor wenige Werte hat: ihr Mittel, wie die anderen Faktoren auch sind. Band und Striche: wo das Mittel liegt, mit 90 %.</translation>
    </message>
</context>
<context>
    <name>hygroloom::ExperimentPanel</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>one drop</source>
        <translation>ein Tropfen</translation>
    </message>
    <message>
        <source>Along the weft</source>
        <translation>In Schussrichtung</translation>
    </message>
    <message>
        <source>Along the warp</source>
        <translation>In Kettrichtung</translation>
    </message>
    <message>
        <source>sample width</source>
        <translation>Breite der Probe</translation>
    </message>
    <message>
        <source>sample height</source>
        <translation>Höhe der Probe</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Add an experiment</source>
        <translation>Einen Versuch hinzufügen</translation>
    </message>
    <message>
        <source>Rename the experiment</source>
        <translation>Den Versuch umbenennen</translation>
    </message>
    <message>
        <source>Delete the experiment</source>
        <translation>Den Versuch löschen</translation>
    </message>
    <message>
        <source>A new type sets the climate, sample and duration of its standard.</source>
        <translation>Eine neue Art setzt Klima, Probe und Dauer ihrer Norm.</translation>
    </message>
    <message>
        <source>Type of experiment</source>
        <translation>Art des Versuchs</translation>
    </message>
    <message>
        <source>Climate</source>
        <translation>Klima</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>direction of the strip</source>
        <translation>Richtung des Streifens</translation>
    </message>
    <message>
        <source>Initial temperature</source>
        <translation>Temperatur am Anfang</translation>
    </message>
    <message>
        <source>Temperature of the air in which the sample was conditioned.</source>
        <translation>Temperatur der Luft, in der die Probe klimatisiert wurde.</translation>
    </message>
    <message>
        <source>Initial humidity</source>
        <translation>Feuchte am Anfang</translation>
    </message>
    <message>
        <source>Relative humidity of the air in which the sample was conditioned.</source>
        <translation>Relative Feuchte der Luft, in der die Probe klimatisiert wurde.</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>sweating face</source>
        <translation>schwitzende Seite</translation>
    </message>
    <message>
        <source>Liquid</source>
        <translation>Flüssigkeit</translation>
    </message>
    <message>
        <source>Mao et al. (as printed)</source>
        <translation>Mao u. a. (wie gedruckt)</translation>
    </message>
    <message>
        <source>Pores in and between yarns</source>
        <translation>Poren in und zwischen Garnen</translation>
    </message>
    <message>
        <source>How liquid moves in the pores of the yarns. Mao et al.: pores of 0.2 mm, one contact angle for all fibres, uptake in proportion to regain. Pores in and between yarns: liquid follows suction, and a stain stops.</source>
        <translation>Wie sich Flüssigkeit in den Poren der Garne bewegt. Mao u. a.: Poren von 0.2 mm, ein Randwinkel für alle Fasern, Aufnahme im Verhältnis zur Feuchteaufnahme. Poren in und zwischen Garnen: Flüssigkeit folgt dem Sog, und ein Fleck kommt zur Ruhe.</translation>
    </message>
    <message>
        <source>Wicking model</source>
        <translation>Saugmodell</translation>
    </message>
    <message>
        <source>wicking model</source>
        <translation>Saugmodell</translation>
    </message>
    <message>
        <source>Wet fibres swell</source>
        <translation>Nasse Fasern quellen</translation>
    </message>
    <message>
        <source>swelling</source>
        <translation>Quellung</translation>
    </message>
    <message>
        <source>Strip width</source>
        <translation>Streifenbreite</translation>
    </message>
    <message>
        <source>Strip length</source>
        <translation>Streifenlänge</translation>
    </message>
    <message>
        <source>type of experiment</source>
        <translation>Art des Versuchs</translation>
    </message>
    <message>
        <source>add experiment</source>
        <translation>Versuch hinzufügen</translation>
    </message>
    <message>
        <source>Rename experiment</source>
        <translation>Versuch umbenennen</translation>
    </message>
    <message>
        <source>rename experiment</source>
        <translation>Versuch umbenennen</translation>
    </message>
    <message>
        <source>delete experiment</source>
        <translation>Versuch löschen</translation>
    </message>
    <message>
        <source>An experiment “%1” already exists. Choose another name.</source>
        <translation>Ein Versuch „%1“ ist schon da. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>initial</source>
        <translation>Anfang</translation>
    </message>
</context>
<context>
    <name>hygroloom::ExportDialog</name>
    <message>
        <source>&amp;Close the ends with caps</source>
        <translation>Enden mit &amp;Kappen schließen</translation>
    </message>
    <message>
        <source>&amp;Loops and hairs</source>
        <translation>Schlin&amp;gen und Faserenden</translation>
    </message>
    <message>
        <source>&amp;Open Folder</source>
        <translation>&amp;Ordner öffnen</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Export Mesh</source>
        <translation>Netz exportieren</translation>
    </message>
    <message>
        <source>Size of the export</source>
        <translation>Größe des Exports</translation>
    </message>
    <message>
        <source>Result of the export</source>
        <translation>Ergebnis des Exports</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Fortschritt des Exports</translation>
    </message>
    <message>
        <source>Not enough memory for this piece. Choose a smaller one.</source>
        <translation>Der Speicher reicht für dieses Stück nicht. Wählen Sie ein kleineres.</translation>
    </message>
    <message>
        <source>%1 samples per crossing are too few for this twist. Use %2 for smooth fibres.</source>
        <translation>%1 Stützstellen je Kreuzungspunkt sind für diese Drehung zu wenige. Nehmen Sie %2 für glatte Fasern.</translation>
    </message>
    <message>
        <source>%1 ends × %2 picks</source>
        <translation>%1 Kettfäden × %2 Schüsse</translation>
    </message>
    <message>
        <source>%1 curves with %2 points</source>
        <translation>%1 Kurven mit %2 Punkten</translation>
    </message>
    <message>
        <source>%1 triangles, %2 vertices</source>
        <translation>%1 Dreiecke, %2 Ecken</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>The file may need up to %1; only %2 are free on the disk.</source>
        <translation>Die Datei braucht vielleicht bis zu %1; auf dem Datenträger sind nur %2 frei.</translation>
    </message>
    <message>
        <source>Many programs cannot open files larger than 1 GB.</source>
        <translation>Viele Programme können Dateien über 1 GB nicht öffnen.</translation>
    </message>
    <message>
        <source>Wrote %1, %2.</source>
        <translation>%1 geschrieben, %2.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>Cancelled. No file was written.</source>
        <translation>Abgebrochen. Es wurde keine Datei geschrieben.</translation>
    </message>
    <message>
        <source>Not enough memory for this export. Choose a smaller piece.</source>
        <translation>Der Speicher reicht für diesen Export nicht. Wählen Sie ein kleineres Stück.</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen …</translation>
    </message>
    <message>
        <source>Exported %1.</source>
        <translation>%1 ist exportiert.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>%1 already exist. Replace them?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>weft × warp</source>
        <translation>Schuss × Kette</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>For&amp;mat</source>
        <translation>For&amp;mat</translation>
    </message>
    <message>
        <source>Yarn centrelines</source>
        <translation>Mittellinien der Garne</translation>
    </message>
    <message>
        <source>Yarn surfaces</source>
        <translation>Oberflächen der Garne</translation>
    </message>
    <message>
        <source>Single fibres</source>
        <translation>Einzelne Fasern</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Detail</translation>
    </message>
    <message>
        <source>&amp;Detail</source>
        <translation>&amp;Detail</translation>
    </message>
    <message>
        <source>Repeats of the fabric</source>
        <translation>Rapporte des Gewebes</translation>
    </message>
    <message>
        <source>By size</source>
        <translation>Nach Größe</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Stück</translation>
    </message>
    <message>
        <source>&amp;Piece</source>
        <translation>S&amp;tück</translation>
    </message>
    <message>
        <source>Along the weft.</source>
        <translation>In Schussrichtung.</translation>
    </message>
    <message>
        <source>Along the warp.</source>
        <translation>In Kettrichtung.</translation>
    </message>
    <message>
        <source>Repeats along the weft</source>
        <translation>Rapporte in Schussrichtung</translation>
    </message>
    <message>
        <source>Repeats along the warp</source>
        <translation>Rapporte in Kettrichtung</translation>
    </message>
    <message>
        <source>Width along the weft</source>
        <translation>Breite in Schussrichtung</translation>
    </message>
    <message>
        <source>Height along the warp</source>
        <translation>Höhe in Kettrichtung</translation>
    </message>
    <message>
        <source>&amp;Repeats</source>
        <translation>&amp;Rapporte</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>Grö&amp;ße</translation>
    </message>
    <message>
        <source>Samples per crossing</source>
        <translation>Stützstellen je Kreuzungspunkt</translation>
    </message>
    <message>
        <source>Rings of a tube, or points of a curve, from one crossing to the next.</source>
        <translation>Ringe eines Schlauchs oder Punkte einer Kurve von einem Kreuzungspunkt zum nächsten.</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Sides of the tube that represents a yarn or a fibre.</source>
        <translation>Seiten des Schlauchs, der ein Garn oder eine Faser darstellt.</translation>
    </message>
    <message>
        <source>&amp;Samples per crossing</source>
        <translation>Stüt&amp;zstellen je Kreuzungspunkt</translation>
    </message>
    <message>
        <source>Sides of a &amp;tube</source>
        <translation>Seiten eines Schlauc&amp;hs</translation>
    </message>
    <message>
        <source>Close the ends with caps</source>
        <translation>Enden mit Kappen schließen</translation>
    </message>
    <message>
        <source>Seed of the fibres</source>
        <translation>Startzahl der Fasern</translation>
    </message>
    <message>
        <source>Start of the random numbers: equal seeds give equal fibres.</source>
        <translation>Beginn der Zufallszahlen: Gleiche Startzahlen geben gleiche Fasern.</translation>
    </message>
    <message>
        <source>Seed of the &amp;fibres</source>
        <translation>Startzahl der &amp;Fasern</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>Date&amp;i</translation>
    </message>
    <message>
        <source>Sample of the experiment, %1 × %2 mm</source>
        <translation>Probe des Versuchs, %1 × %2 mm</translation>
    </message>
    <message>
        <source>Sample of the experiment (there is none)</source>
        <translation>Probe des Versuchs (es gibt keine)</translation>
    </message>
    <message>
        <source>Simulated piece with its water at %1 s</source>
        <translation>Simuliertes Stück mit seinem Wasser bei %1 s</translation>
    </message>
    <message>
        <source>Simulated piece (open a recording, or run)</source>
        <translation>Simuliertes Stück (Aufzeichnung öffnen oder rechnen)</translation>
    </message>
    <message>
        <source>This project has no fabric to export.</source>
        <translation>Dieses Projekt hat kein Gewebe zum Exportieren.</translation>
    </message>
    <message>
        <source>This fabric has an error and cannot be exported. See the Issues panel.</source>
        <translation>Dieses Gewebe hat einen Fehler und lässt sich nicht exportieren. Siehe das Feld Meldungen.</translation>
    </message>
    <message>
        <source>Enter a file name.</source>
        <translation>Geben Sie einen Dateinamen ein.</translation>
    </message>
    <message>
        <source>This is a folder. Enter a file name.</source>
        <translation>Das ist ein Ordner. Geben Sie einen Dateinamen ein.</translation>
    </message>
    <message>
        <source>The folder %1 does not exist.</source>
        <translation>Den Ordner %1 gibt es nicht.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be written to.</source>
        <translation>In den Ordner %1 lässt sich nicht schreiben.</translation>
    </message>
    <message>
        <source>%1 (*%2)</source>
        <translation>%1 (*%2)</translation>
    </message>
    <message>
        <source>What is in it now is lost.</source>
        <translation>Was darin steht, geht verloren.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
</context>
<context>
    <name>hygroloom::FabricPanel</name>
    <message>
        <source>Construction</source>
        <translation>Konstruktion</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Calculate the thickness from the yarns</source>
        <translation>Die Dicke aus den Garnen berechnen</translation>
    </message>
    <message>
        <source>As the fibres</source>
        <translation>Wie die Fasern</translation>
    </message>
    <message>
        <source>%1, %2°</source>
        <translation>%1, %2°</translation>
    </message>
    <message>
        <source>Own contact angle</source>
        <translation>Eigener Randwinkel</translation>
    </message>
    <message>
        <source>Sets the contact angle above to a typical value for the finish. Measure your own fabric if you can.</source>
        <translation>Setzt den Randwinkel oben auf einen typischen Wert der Ausrüstung. Messen Sie Ihr eigenes Gewebe, wenn Sie können.</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Ausrüstung</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>Ausrüstung</translation>
    </message>
    <message>
        <source>Receding angle</source>
        <translation>Rückzugswinkel</translation>
    </message>
    <message>
        <source>Contact angle of water that draws back, of warp and weft; 0 on cotton, flax, hemp and viscose, else 20° less than the contact angle, both assumed, unless the material gives one. Acts in the closure “pores” only.</source>
        <translation>Randwinkel von Wasser, das sich zurückzieht, von Kette und Schuss; 0 auf Baumwolle, Flachs, Hanf und Viskose, sonst 20° weniger als der Randwinkel, beides angenommen, wenn der Werkstoff keinen nennt. Wirkt nur im Saugmodell mit Poren.</translation>
    </message>
    <message>
        <source>%1° × %2°</source>
        <translation>%1° × %2°</translation>
    </message>
    <message>
        <source>Calculated</source>
        <translation>Berechnet</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Flächengewicht</translation>
    </message>
    <message>
        <source>Dry mass per area.</source>
        <translation>Trockenmasse je Fläche.</translation>
    </message>
    <message>
        <source>Cover factor</source>
        <translation>Deckungsgrad</translation>
    </message>
    <message>
        <source>Share of the area that yarns hide, seen from above; the rest are holes between them. 1: no hole.</source>
        <translation>Anteil der Fläche, den Garne von oben gesehen verdecken; der Rest sind Löcher zwischen ihnen. 1: kein Loch.</translation>
    </message>
    <message>
        <source>Yarn path</source>
        <translation>Garnverlauf</translation>
    </message>
    <message>
        <source>Round: yarns cross in circular arcs (Peirce). Flattened: the sett is too dense for full arcs, so yarns are flattened where they cross.</source>
        <translation>Rund: Garne kreuzen sich in Kreisbögen (Peirce). Abgeflacht: Die Fadendichte ist für volle Bögen zu groß, daher sind die Garne an den Kreuzungspunkten abgeflacht.</translation>
    </message>
    <message>
        <source>Porosity</source>
        <translation>Porosität</translation>
    </message>
    <message>
        <source>Share of the fabric&apos;s volume that is air, in yarns and between them.</source>
        <translation>Anteil des Gewebevolumens, der Luft ist, in Garnen und zwischen ihnen.</translation>
    </message>
    <message>
        <source>Yarn layer</source>
        <translation>Garnschicht</translation>
    </message>
    <message>
        <source>Thickness of the interlaced yarns.</source>
        <translation>Dicke der verwebten Garne.</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>Between neighbouring ends × between neighbouring picks.</source>
        <translation>Zwischen benachbarten Kettfäden × zwischen benachbarten Schüssen.</translation>
    </message>
    <message>
        <source>flattened at crossings</source>
        <translation>an Kreuzungen abgeflacht</translation>
    </message>
    <message>
        <source>round (Peirce)</source>
        <translation>rund (Peirce)</translation>
    </message>
    <message>
        <source>Flyaways</source>
        <translation>Abstehende Fasern</translation>
    </message>
    <message>
        <source>Measured in the laboratory</source>
        <translation>Im Labor gemessen</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>On the loom</source>
        <translation>Auf dem Webstuhl</translation>
    </message>
    <message>
        <source>Reed</source>
        <translation>Webblatt</translation>
    </message>
    <message>
        <source>Dents in 10 cm, from ends in the reed and ends a dent.</source>
        <translation>Rohre auf 10 cm, aus der Kettdichte im Blatt und den Fäden je Rohr.</translation>
    </message>
    <message>
        <source>Shrinks in width</source>
        <translation>Springt in der Breite ein</translation>
    </message>
    <message>
        <source>From the reed to the finished cloth, of its width.</source>
        <translation>Vom Blatt bis zum fertigen Stoff, bezogen auf dessen Breite.</translation>
    </message>
    <message>
        <source>Shrinks in length</source>
        <translation>Springt in der Länge ein</translation>
    </message>
    <message>
        <source>From the loom to the finished cloth, of its length.</source>
        <translation>Vom Webstuhl bis zum fertigen Stoff, bezogen auf dessen Länge.</translation>
    </message>
</context>
<context>
    <name>hygroloom::FactorForm</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1, step %2</source>
        <translation>%1, Schritt %2</translation>
    </message>
    <message>
        <source>%1, logarithmic</source>
        <translation>%1, logarithmisch</translation>
    </message>
    <message>
        <source>normal, %1 ± %2</source>
        <translation>normal, %1 ± %2</translation>
    </message>
    <message>
        <source>lognormal, %1 ± %2</source>
        <translation>lognormal, %1 ± %2</translation>
    </message>
    <message>
        <source>%1, most often %2</source>
        <translation>%1, am häufigsten %2</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>List of values</source>
        <translation>Werteliste</translation>
    </message>
    <message>
        <source>Range, logarithmic</source>
        <translation>Bereich, logarithmisch</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Lognormal</source>
        <translation>Lognormal</translation>
    </message>
    <message>
        <source>Triangular</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>How the factor is spread</source>
        <translation>Wie der Faktor verteilt ist</translation>
    </message>
    <message>
        <source>Spread:</source>
        <translation>Verteilung:</translation>
    </message>
    <message>
        <source>Values:</source>
        <translation>Werte:</translation>
    </message>
    <message>
        <source>Numbers or words, separated by commas: 20, 40, 60</source>
        <translation>Zahlen oder Wörter, durch Kommas getrennt: 20, 40, 60</translation>
    </message>
    <message>
        <source>Mean:</source>
        <translation>Mittel:</translation>
    </message>
    <message>
        <source>Standard deviation:</source>
        <translation>Standardabweichung:</translation>
    </message>
    <message>
        <source>From:</source>
        <translation>Von:</translation>
    </message>
    <message>
        <source>Most often:</source>
        <translation>Am häufigsten:</translation>
    </message>
    <message>
        <source>To:</source>
        <translation>Bis:</translation>
    </message>
    <message>
        <source>Step:</source>
        <translation>Schritt:</translation>
    </message>
    <message>
        <source>Only values that are whole steps from the lowest; empty: any value.</source>
        <translation>Nur Werte, die ganze Schritte vom kleinsten entfernt sind; leer: jeder Wert.</translation>
    </message>
    <message>
        <source>Levels:</source>
        <translation>Stufen:</translation>
    </message>
    <message>
        <source>On a grid, and one at a time; empty: as many as the points allow.</source>
        <translation>Auf einem Gitter und bei einzeln; leer: so viele, wie die Punkte erlauben.</translation>
    </message>
    <message>
        <source>Base:</source>
        <translation>Grundwert:</translation>
    </message>
    <message>
        <source>Where other factors change one at a time; empty: the project&apos;s own value.</source>
        <translation>Wo andere Faktoren sich einzeln ändern; leer: der Wert des Projekts.</translation>
    </message>
    <message>
        <source>no bound</source>
        <translation>ohne Grenze</translation>
    </message>
    <message>
        <source>%1 is missing; type a number.</source>
        <translation>%1 fehlt; geben Sie eine Zahl ein.</translation>
    </message>
    <message>
        <source>%1 must be a number; given is “%2”.</source>
        <translation>%1 muss eine Zahl sein; eingegeben ist „%2“.</translation>
    </message>
    <message>
        <source>The list is empty; type values separated by commas.</source>
        <translation>Die Liste ist leer; geben Sie durch Kommas getrennte Werte ein.</translation>
    </message>
    <message>
        <source>The mean</source>
        <translation>Das Mittel</translation>
    </message>
    <message>
        <source>The standard deviation</source>
        <translation>Die Standardabweichung</translation>
    </message>
    <message>
        <source>The lowest value</source>
        <translation>Der kleinste Wert</translation>
    </message>
    <message>
        <source>The most frequent value</source>
        <translation>Der häufigste Wert</translation>
    </message>
    <message>
        <source>The highest value</source>
        <translation>Der größte Wert</translation>
    </message>
    <message>
        <source>The step</source>
        <translation>Der Schritt</translation>
    </message>
    <message>
        <source>The number of levels</source>
        <translation>Die Zahl der Stufen</translation>
    </message>
    <message>
        <source>The number of levels must be a whole number from 2 to 10000; given is %1.</source>
        <translation>Die Zahl der Stufen muss eine ganze Zahl von 2 bis 10000 sein; eingegeben ist %1.</translation>
    </message>
</context>
<context>
    <name>hygroloom::FibrePanel</name>
    <message>
        <source>Fibres of the project</source>
        <translation>Fasern des Projekts</translation>
    </message>
    <message>
        <source>Duplicate the fibre</source>
        <translation>Die Faser duplizieren</translation>
    </message>
    <message>
        <source>Rename the fibre</source>
        <translation>Die Faser umbenennen</translation>
    </message>
    <message>
        <source>Delete the fibre</source>
        <translation>Die Faser löschen</translation>
    </message>
    <message>
        <source>Fibre of the project</source>
        <translation>Faser des Projekts</translation>
    </message>
    <message>
        <source>About the fibre</source>
        <translation>Über die Faser</translation>
    </message>
    <message>
        <source>own perimeter</source>
        <translation>eigener Umfang</translation>
    </message>
    <message>
        <source>Acts in the closure “pores” only.</source>
        <translation>Wirkt nur im Saugmodell mit Poren.</translation>
    </message>
    <message>
        <source>A fibre of more surface draws water in more strongly.</source>
        <translation>Eine Faser mit mehr Oberfläche saugt Wasser stärker an.</translation>
    </message>
    <message>
        <source>Cross-section</source>
        <translation>Querschnitt</translation>
    </message>
    <message>
        <source>cross-section</source>
        <translation>Querschnitt</translation>
    </message>
    <message>
        <source>Perimeter ratio</source>
        <translation>Umfangsverhältnis</translation>
    </message>
    <message>
        <source>perimeter of the fibre</source>
        <translation>Umfang der Faser</translation>
    </message>
    <message>
        <source>Of the cross-section, over that of a circle of the same area; deep-grooved fibres reach 2.5 to 3.</source>
        <translation>Des Querschnitts, geteilt durch den eines Kreises gleicher Fläche; tief gerillte Fasern erreichen 2,5 bis 3.</translation>
    </message>
    <message>
        <source>as the fibre it is based on</source>
        <translation>wie die Ausgangsfaser</translation>
    </message>
    <message>
        <source>master curve</source>
        <translation>Einheitskurve</translation>
    </message>
    <message>
        <source>own numbers</source>
        <translation>eigene Zahlen</translation>
    </message>
    <message>
        <source>Regain over relative humidity. The master curve goes through the standard regain.</source>
        <translation>Feuchteaufnahme über der relativen Feuchte. Die Einheitskurve geht durch die Feuchteaufnahme im Normalklima.</translation>
    </message>
    <message>
        <source>Isotherm</source>
        <translation>Isotherme</translation>
    </message>
    <message>
        <source>isotherm</source>
        <translation>Isotherme</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>No fabric uses it.</source>
        <translation>Kein Gewebe verwendet sie.</translation>
    </message>
    <message>
        <source>Used by %1.</source>
        <translation>Verwendet von %1.</translation>
    </message>
    <message>
        <source>Based on %1. %2</source>
        <translation>Beruht auf %1. %2</translation>
    </message>
    <message>
        <source>duplicate fibre</source>
        <translation>Faser duplizieren</translation>
    </message>
    <message>
        <source>A fibre needs a name.</source>
        <translation>Eine Faser braucht einen Namen.</translation>
    </message>
    <message>
        <source>A fibre “%1” already exists. Choose another name.</source>
        <translation>Eine Faser „%1“ gibt es schon. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>rename fibre</source>
        <translation>Faser umbenennen</translation>
    </message>
    <message>
        <source>delete fibre</source>
        <translation>Faser löschen</translation>
    </message>
    <message>
        <source>Rename fibre</source>
        <translation>Faser umbenennen</translation>
    </message>
    <message>
        <source>Delete fibre</source>
        <translation>Faser löschen</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>„%1“ löschen?</translation>
    </message>
    <message>
        <source>“%1” is used by %2. They will use %3 instead.</source>
        <translation>„%1“ wird von %2 verwendet. Stattdessen wird dort %3 verwendet.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>None yet. “Own…” beside the fibre of a yarn makes one of it.</source>
        <translation>Noch keine. „Eigene…“ neben der Faser eines Garns macht daraus eine.</translation>
    </message>
    <message>
        <source>fibre&apos;s</source>
        <translation>Faser:</translation>
    </message>
</context>
<context>
    <name>hygroloom::FieldPicker</name>
    <message>
        <source>Add Factors</source>
        <translation>Faktoren hinzufügen</translation>
    </message>
    <message>
        <source>Letters of a name, such as “angle” or “weft twist”</source>
        <translation>Buchstaben eines Namens, etwa „Winkel“ oder „Schuss Drehung“</translation>
    </message>
    <message>
        <source>Find a field</source>
        <translation>Feld suchen</translation>
    </message>
    <message>
        <source>Fields of the project</source>
        <translation>Felder des Projekts</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Pfad</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>A study changes these. Hold Ctrl to choose several.</source>
        <translation>Eine Studie ändert diese. Mit gehaltener Strg-Taste wählen Sie mehrere.</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <source>It is a factor already.</source>
        <translation>Es ist schon ein Faktor.</translation>
    </message>
    <message>
        <source>The study does not run this one.</source>
        <translation>Die Studie rechnet dies nicht.</translation>
    </message>
</context>
<context>
    <name>hygroloom::Film</name>
    <message>
        <source>MP4 needs the program ffmpeg, which is not installed. Save pictures instead, or install it: apt install ffmpeg.</source>
        <translation>MP4 braucht das Programm ffmpeg, das nicht installiert ist. Sichern Sie stattdessen Bilder, oder installieren Sie es: apt install ffmpeg.</translation>
    </message>
    <message>
        <source>No picture was taken, so there is no film.</source>
        <translation>Es wurde kein Bild aufgenommen, also gibt es keinen Film.</translation>
    </message>
    <message>
        <source>Some pictures cannot be written to %1. Is the disk full?</source>
        <translation>Einige Bilder lassen sich nicht nach %1 schreiben. Ist die Platte voll?</translation>
    </message>
    <message>
        <source>Saved %1 pictures to %2.</source>
        <translation>%1 Bilder in %2 gesichert.</translation>
    </message>
    <message>
        <source>Saved %1 pictures to %2; %3 were left out because the disk was too slow.</source>
        <translation>%1 Bilder in %2 gesichert; %3 wurden ausgelassen, weil die Platte zu langsam war.</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gesichert.</translation>
    </message>
    <message>
        <source>The film cannot be written to %1. ffmpeg said: %2</source>
        <translation>Der Film lässt sich nicht nach %1 schreiben. ffmpeg meldet: %2</translation>
    </message>
    <message>
        <source>Saved %1; %2 of its pictures were left out because ffmpeg was too slow.</source>
        <translation>%1 ist gespeichert; %2 Bilder fehlen darin, weil ffmpeg zu langsam war.</translation>
    </message>
    <message>
        <source>The film cannot be written to %1. Is the disk full?</source>
        <translation>Der Film lässt sich nicht nach %1 schreiben. Ist der Datenträger voll?</translation>
    </message>
    <message>
        <source>There is no film because %1 cannot be started: %2</source>
        <translation>Es gibt keinen Film, weil %1 nicht startet: %2</translation>
    </message>
</context>
<context>
    <name>hygroloom::FingerprintView</name>
    <message>
        <source>What the fingerprint shows</source>
        <translation>Was der Fingerabdruck zeigt</translation>
    </message>
    <message>
        <source>Fingerprint of the ticked runs</source>
        <translation>Fingerabdruck der angekreuzten Läufe</translation>
    </message>
    <message>
        <source>Tick two to four fabrics above to see their fingerprints.</source>
        <translation>Kreuzen Sie oben zwei bis vier Gewebe an, um ihre Fingerabdrücke zu sehen.</translation>
    </message>
    <message>
        <source>A fingerprint needs three numbers or more; this experiment has %1. See Scatter.</source>
        <translation>Ein Fingerabdruck braucht drei Zahlen oder mehr; dieser Versuch hat %1. Siehe Streudiagramm.</translation>
    </message>
    <message>
        <source>Grades of AATCC 195 of each cloth as given: 1 poor (inside) to 5 excellent (rim).</source>
        <translation>Noten nach AATCC 195 jedes Gewebes wie angegeben: 1 schlecht (innen) bis 5 ausgezeichnet (Rand).</translation>
    </message>
    <message>
        <source>Each number from the worst (middle) to the best (rim) of the %1 candidates in the table. Differences are drawn however small they are: the table says which are real.</source>
        <translation>Jede Zahl vom schlechtesten (Mitte) bis zum besten (Rand) der %1 Kandidaten der Tabelle. Unterschiede sind gezeichnet, wie klein sie auch sind: Die Tabelle sagt, welche echt sind.</translation>
    </message>
</context>
<context>
    <name>hygroloom::FitChart</name>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>angepasst</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Measured and simulated curves</source>
        <translation>Gemessene und simulierte Kurven</translation>
    </message>
    <message>
        <source>%1: %2 %3 at %4 s</source>
        <translation>%1: %2 %3 bei %4 s</translation>
    </message>
</context>
<context>
    <name>hygroloom::FitForm</name>
    <message>
        <source>Gaps between skin and cloth</source>
        <translation>Abstände zwischen Haut und Stoff</translation>
    </message>
    <message>
        <source>Zone</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Lässt durch</translation>
    </message>
    <message>
        <source>Gap between skin and cloth</source>
        <translation>Abstand zwischen Haut und Stoff</translation>
    </message>
    <message>
        <source>Share of the water that seams pass</source>
        <translation>Anteil des Wassers, den Nähte durchlassen</translation>
    </message>
    <message>
        <source>all others</source>
        <translation>alle anderen</translation>
    </message>
    <message>
        <source>Gap: %1</source>
        <translation>Abstand: %1</translation>
    </message>
    <message>
        <source>change gap: %1</source>
        <translation>Abstand ändern: %1</translation>
    </message>
    <message>
        <source>Where cloth rests on the shoulder. Empty: as the zone there. 0: they touch.</source>
        <translation>Wo der Stoff auf der Schulter aufliegt. Leer: wie die Zone dort. 0: Sie berühren sich.</translation>
    </message>
    <message>
        <source>Of zones that have no gap of their own. Empty: 3 mm. 0: they touch.</source>
        <translation>Von Zonen, die keinen eigenen Abstand haben. Leer: 3 mm. 0: Sie berühren sich.</translation>
    </message>
    <message>
        <source>Empty: as all others. 0: they touch.</source>
        <translation>Leer: wie alle anderen. 0: Sie berühren sich.</translation>
    </message>
    <message>
        <source>Seam: %1</source>
        <translation>Naht: %1</translation>
    </message>
    <message>
        <source>change seam: %1</source>
        <translation>Naht ändern: %1</translation>
    </message>
    <message>
        <source>Of seams that have no share of their own. Empty: 100 %, as where cloth overlaps; 0 %: taped.</source>
        <translation>Von Nähten, die keinen eigenen Anteil haben. Leer: 100 %, wie wo Stoff sich überlappt; 0 %: verklebt.</translation>
    </message>
    <message>
        <source>100 %: as where cloth overlaps; 0 %: taped. Empty: as all others.</source>
        <translation>100 %: wie wo Stoff sich überlappt; 0 %: verklebt. Leer: wie alle anderen.</translation>
    </message>
</context>
<context>
    <name>hygroloom::FlatView</name>
    <message>
        <source>Flat panels of the garment</source>
        <translation>Flache Schnittteile des Kleidungsstücks</translation>
    </message>
    <message>
        <source>Drag to move, wheel to zoom, click to pin a place. Plus and minus zoom, Home shows all panels.</source>
        <translation>Ziehen verschiebt, das Rad vergrößert, Klicken heftet einen Ort an. Plus und Minus vergrößern und verkleinern, Pos1 zeigt alle Schnittteile.</translation>
    </message>
</context>
<context>
    <name>hygroloom::GarmentMaps</name>
    <message>
        <source>3D and flat</source>
        <translation>3D, flach</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>What is drawn of the garments</source>
        <translation>Was von den Kleidungsstücken gezeichnet ist</translation>
    </message>
    <message>
        <source>Water, g/m²</source>
        <translation>Wasser, g/m²</translation>
    </message>
    <message>
        <source>Share of capacity</source>
        <translation>Füllgrad</translation>
    </message>
    <message>
        <source>Difference of water</source>
        <translation>Unterschied des Wassers</translation>
    </message>
    <message>
        <source>Difference of shares</source>
        <translation>Unterschied des Füllgrads</translation>
    </message>
    <message>
        <source>What the colours show</source>
        <translation>Was die Farben zeigen</translation>
    </message>
    <message>
        <source>Time of all garments</source>
        <translation>Zeit aller Kleidungsstücke</translation>
    </message>
    <message>
        <source>Place under the pointer</source>
        <translation>Ort unter dem Zeiger</translation>
    </message>
    <message>
        <source>Water on %1</source>
        <translation>Wasser auf %1</translation>
    </message>
    <message>
        <source>Tick a second fabric to see how it differs.</source>
        <translation>Kreuzen Sie ein zweites Gewebe an, um zu sehen, wie es sich unterscheidet.</translation>
    </message>
    <message>
        <source>%1: %2 g/m², %3 % of capacity</source>
        <translation>%1: %2 g/m², Füllgrad %3 %</translation>
    </message>
    <message>
        <source>%1, zone %2: %3</source>
        <translation>%1, Zone %2: %3</translation>
    </message>
    <message>
        <source>Share of capacity, %</source>
        <translation>Füllgrad, %</translation>
    </message>
    <message>
        <source>Difference, %</source>
        <translation>Unterschied, %</translation>
    </message>
    <message>
        <source>Difference, g/m²</source>
        <translation>Unterschied, g/m²</translation>
    </message>
</context>
<context>
    <name>hygroloom::GarmentPanel</name>
    <message>
        <source>Fabrics to drag onto panels</source>
        <translation>Gewebe, die sich auf Schnittteile ziehen lassen</translation>
    </message>
    <message>
        <source>Drag a fabric onto a panel. A double click cuts all panels from it.</source>
        <translation>Ziehen Sie ein Gewebe auf ein Schnittteil. Ein Doppelklick schneidet alle Schnittteile aus ihm zu.</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Schnittteile</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Wearer</source>
        <translation>Träger</translation>
    </message>
    <message>
        <source>Garment</source>
        <translation>Kleidungsstück</translation>
    </message>
    <message>
        <source>Add a garment</source>
        <translation>Ein Kleidungsstück hinzufügen</translation>
    </message>
    <message>
        <source>Built-in %1</source>
        <translation>Eingebaut: %1</translation>
    </message>
    <message>
        <source>Pattern or Mesh from a File…</source>
        <translation>Schnitt oder Netz aus einer Datei…</translation>
    </message>
    <message>
        <source>Rename the garment</source>
        <translation>Das Kleidungsstück umbenennen</translation>
    </message>
    <message>
        <source>Rename the Garment</source>
        <translation>Kleidungsstück umbenennen</translation>
    </message>
    <message>
        <source>Remove the garment and its experiments</source>
        <translation>Das Kleidungsstück und seine Versuche entfernen</translation>
    </message>
    <message>
        <source>Chest</source>
        <translation>Brust</translation>
    </message>
    <message>
        <source>change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>change skin temperature</source>
        <translation>Hauttemperatur ändern</translation>
    </message>
    <message>
        <source>Gap between skin and cloth</source>
        <translation>Abstand zwischen Haut und Stoff</translation>
    </message>
    <message>
        <source>change gap</source>
        <translation>Abstand ändern</translation>
    </message>
    <message>
        <source>Air between skin and cloth, where the project names no other gap for a zone; 0: they touch.</source>
        <translation>Luft zwischen Haut und Stoff, wo das Projekt für eine Zone keinen anderen Abstand nennt; 0: Sie berühren sich.</translation>
    </message>
    <message>
        <source>Sweat rates of the zones</source>
        <translation>Schweißraten der Zonen</translation>
    </message>
    <message>
        <source>Sweat of each zone of the body: Taylor and Machado-Moreira 2013, table 4, or a CSV with the columns zone and g_m2_h.</source>
        <translation>Schweiß jeder Zone des Körpers: Taylor und Machado-Moreira 2013, Tafel 4, oder eine CSV-Datei mit den Spalten zone und g_m2_h.</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Gap to skin</source>
        <translation>Abstand zur Haut</translation>
    </message>
    <message>
        <source>Sweat</source>
        <translation>Schweiß</translation>
    </message>
    <message>
        <source>Sweat Rates</source>
        <translation>Schweißraten</translation>
    </message>
    <message>
        <source>Tables of zones (*.csv)</source>
        <translation>Tabellen von Zonen (*.csv)</translation>
    </message>
    <message>
        <source>choose sweat rates</source>
        <translation>Schweißraten wählen</translation>
    </message>
    <message>
        <source>Add a Garment</source>
        <translation>Kleidungsstück hinzufügen</translation>
    </message>
    <message>
        <source>Patterns and meshes (*.json *.obj *.glb *.gltf *.fbx *.ply *.dae);;All files (*)</source>
        <translation>Schnitte und Netze (*.json *.obj *.glb *.gltf *.fbx *.ply *.dae);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Hip</source>
        <translation>Hüfte</translation>
    </message>
    <message>
        <source>From a CSV File…</source>
        <translation>Aus einer CSV-Datei…</translation>
    </message>
    <message>
        <source>There is no garment to rename.</source>
        <translation>Es gibt kein Kleidungsstück zum Umbenennen.</translation>
    </message>
    <message>
        <source>There is no garment to remove.</source>
        <translation>Es gibt kein Kleidungsstück zum Entfernen.</translation>
    </message>
    <message>
        <source>At rest, Taylor 2013</source>
        <translation>In Ruhe, Taylor 2013</translation>
    </message>
    <message>
        <source>Exercise, Taylor 2013</source>
        <translation>Bei Belastung, Taylor 2013</translation>
    </message>
</context>
<context>
    <name>hygroloom::GarmentSubject</name>
    <message>
        <source>Add Built-in %1</source>
        <translation>Eingebaut hinzufügen: %1</translation>
    </message>
    <message>
        <source>Add a %1 and an experiment in which it is worn.</source>
        <translation>%1 hinzufügen und einen Versuch, in dem es getragen wird.</translation>
    </message>
    <message>
        <source>Add Garment from a &amp;File…</source>
        <translation>Kleidungsstück aus &amp;Datei hinzufügen…</translation>
    </message>
    <message>
        <source>Add a sewing pattern, or a mesh with flat coordinates.</source>
        <translation>Einen Schnitt oder ein Netz mit flachen Koordinaten hinzufügen.</translation>
    </message>
    <message>
        <source>Remove &amp;Garment</source>
        <translation>Kleidungsstück en&amp;tfernen</translation>
    </message>
    <message>
        <source>&amp;Keep This Run as A</source>
        <translation>Diesen &amp;Lauf als A behalten</translation>
    </message>
    <message>
        <source>Compare the next runs with this one.</source>
        <translation>Die nächsten Läufe mit diesem vergleichen.</translation>
    </message>
    <message>
        <source>&amp;Drop A</source>
        <translation>&amp;A verwerfen</translation>
    </message>
    <message>
        <source>Show the newest run alone.</source>
        <translation>Nur den neuesten Lauf zeigen.</translation>
    </message>
    <message>
        <source>S&amp;teps of the Colours…</source>
        <translation>&amp;Farbstufen…</translation>
    </message>
    <message>
        <source>Set where each of the eight colours ends.</source>
        <translation>Setzt, wo jede der acht Farben endet.</translation>
    </message>
    <message>
        <source>Save &amp;A As…</source>
        <translation>A speichern u&amp;nter…</translation>
    </message>
    <message>
        <source>Save &amp;Map…</source>
        <translation>&amp;Karte speichern…</translation>
    </message>
    <message>
        <source>Write pictures and textures of the panels, a table of cells, OBJ and GLB of the time shown to a folder.</source>
        <translation>Schreibt Bilder und Texturen der Schnittteile, eine Tabelle der Zellen, OBJ und GLB der gezeigten Zeit in einen Ordner.</translation>
    </message>
    <message>
        <source>&amp;Copy Numbers as CSV</source>
        <translation>Zahlen als &amp;CSV kopieren</translation>
    </message>
    <message>
        <source>Copy the numbers per panel and zone.</source>
        <translation>Die Zahlen je Schnittteil und Zone kopieren.</translation>
    </message>
    <message>
        <source>Add a garment.</source>
        <translation>Fügen Sie ein Kleidungsstück hinzu.</translation>
    </message>
    <message>
        <source>Add an experiment on this garment.</source>
        <translation>Fügen Sie einen Versuch mit diesem Kleidungsstück hinzu.</translation>
    </message>
    <message>
        <source>The garment&apos;s pattern is being read.</source>
        <translation>Der Schnitt des Kleidungsstücks wird gelesen.</translation>
    </message>
    <message>
        <source>Cells about 12 mm wide.</source>
        <translation>Zellen etwa 12 mm breit.</translation>
    </message>
    <message>
        <source>Cells about 6 mm wide.</source>
        <translation>Zellen etwa 6 mm breit.</translation>
    </message>
    <message>
        <source>Cells about 3 mm wide.</source>
        <translation>Zellen etwa 3 mm breit.</translation>
    </message>
    <message>
        <source>Cells about 1.5 mm wide.</source>
        <translation>Zellen etwa 1.5 mm breit.</translation>
    </message>
    <message>
        <source>Choose a lower fidelity.</source>
        <translation>Wählen Sie eine geringere Genauigkeit.</translation>
    </message>
    <message>
        <source>Remove the chosen garment and its experiments.</source>
        <translation>Das gewählte Kleidungsstück und seine Versuche entfernen.</translation>
    </message>
    <message>
        <source>There is no garment to remove.</source>
        <translation>Es gibt kein Kleidungsstück zum Entfernen.</translation>
    </message>
    <message>
        <source>A run of this garment is kept with the project.</source>
        <translation>Ein Lauf dieses Kleidungsstücks liegt beim Projekt.</translation>
    </message>
    <message>
        <source>A run of this garment is kept with the project; it is of an older design.</source>
        <translation>Ein Lauf dieses Kleidungsstücks liegt beim Projekt; er ist von einem älteren Entwurf.</translation>
    </message>
    <message>
        <source>Open the kept run of %1</source>
        <translation>Den Lauf vom %1 öffnen</translation>
    </message>
    <message>
        <source>Making the report.</source>
        <translation>Der Bericht wird erstellt.</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Save Map in a Folder</source>
        <translation>Karte in einem Ordner speichern</translation>
    </message>
    <message>
        <source>%1 at %2 s</source>
        <translation>%1 bei %2 s</translation>
    </message>
    <message>
        <source>%1: The folder cannot be made.</source>
        <translation>%1: Der Ordner lässt sich nicht anlegen.</translation>
    </message>
    <message>
        <source>Saved %1 files to %2.</source>
        <translation>%1 Dateien in %2 gespeichert.</translation>
    </message>
    <message>
        <source>about 4 min, 38 MB</source>
        <translation>etwa 4 min, 38 MB</translation>
    </message>
    <message>
        <source>Write the run that is kept as A to another recording, and beside it the files of its garment.</source>
        <translation>Den als A behaltenen Lauf in eine andere Aufzeichnung schreiben, und daneben die Dateien seines Kleidungsstücks.</translation>
    </message>
</context>
<context>
    <name>hygroloom::GarmentView</name>
    <message>
        <source>%1, %2: %3, %4</source>
        <translation>%1, %2: %3, %4</translation>
    </message>
    <message>
        <source>%1, stopped at %2</source>
        <translation>%1, gestoppt bei %2</translation>
    </message>
    <message>
        <source>Place under the pointer</source>
        <translation>Ort unter dem Zeiger</translation>
    </message>
    <message>
        <source>This project has no garment yet.</source>
        <translation>Dieses Projekt hat noch kein Kleidungsstück.</translation>
    </message>
    <message>
        <source>Add the built-in tee</source>
        <translation>Das eingebaute T-Shirt hinzufügen</translation>
    </message>
    <message>
        <source>Adds a tee, cut from the project&apos;s first fabric, and an experiment in which it is worn.</source>
        <translation>Fügt ein T-Shirt hinzu, aus dem ersten Gewebe des Projekts geschnitten, und einen Versuch, in dem es getragen wird.</translation>
    </message>
    <message>
        <source>Steps…</source>
        <translation>Stufen…</translation>
    </message>
    <message>
        <source>Set where each of the eight colours ends.</source>
        <translation>Setzt, wo jede der acht Farben endet.</translation>
    </message>
    <message>
        <source>cut %1 from %2</source>
        <translation>%1 aus %2 zuschneiden</translation>
    </message>
    <message>
        <source>Reading the garment.</source>
        <translation>Das Kleidungsstück wird gelesen.</translation>
    </message>
    <message>
        <source>%1 in its fabrics</source>
        <translation>%1 in seinen Geweben</translation>
    </message>
    <message>
        <source>. Not an experiment of this project.</source>
        <translation>. Kein Versuch dieses Projekts.</translation>
    </message>
    <message>
        <source>Difference B − A</source>
        <translation>Differenz B − A</translation>
    </message>
    <message>
        <source>, ended before this time</source>
        <translation>, endete vor dieser Zeit</translation>
    </message>
    <message>
        <source>, at %1</source>
        <translation>, bei %1</translation>
    </message>
    <message>
        <source>Share of capacity, %</source>
        <translation>Füllgrad, %</translation>
    </message>
    <message>
        <source>Water, g/m²</source>
        <translation>Wasser, g/m²</translation>
    </message>
    <message>
        <source>Difference B − A, %</source>
        <translation>Differenz B − A, %</translation>
    </message>
    <message>
        <source>Difference B − A, g/m²</source>
        <translation>Differenz B − A, g/m²</translation>
    </message>
    <message>
        <source>Point at a cell to read its value; click to pin it.</source>
        <translation>Zeigen Sie auf eine Zelle, um ihren Wert zu lesen; klicken Sie, um sie anzuheften.</translation>
    </message>
    <message>
        <source>Drag a fabric onto a panel, or choose it in the table.</source>
        <translation>Ziehen Sie ein Gewebe auf ein Schnittteil oder wählen Sie es in der Tabelle.</translation>
    </message>
    <message>
        <source>%1: %2, grain %3°</source>
        <translation>%1: %2, Fadenlauf %3°</translation>
    </message>
    <message>
        <source>%1 has no fabric</source>
        <translation>%1 hat kein Gewebe</translation>
    </message>
    <message>
        <source>%1 g/m², %2 % of capacity</source>
        <translation>%1 g/m², Füllgrad %2 %</translation>
    </message>
    <message>
        <source>A: %1; B: %2</source>
        <translation>A: %1; B: %2</translation>
    </message>
    <message>
        <source>%1, zone %2: %3; %4</source>
        <translation>%1, Zone %2: %3; %4</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>Was gezeichnet ist</translation>
    </message>
    <message>
        <source>3D and flat</source>
        <translation>3D, flach</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>What the colours show</source>
        <translation>Was die Farben zeigen</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Share of capacity</source>
        <translation>Füllgrad</translation>
    </message>
    <message>
        <source>Which runs are drawn</source>
        <translation>Welche Läufe gezeichnet sind</translation>
    </message>
    <message>
        <source>Newest run</source>
        <translation>Neuester Lauf</translation>
    </message>
    <message>
        <source>A | B</source>
        <translation>A | B</translation>
    </message>
    <message>
        <source>A | B | B − A</source>
        <translation>A | B | B − A</translation>
    </message>
    <message>
        <source>End of the scale</source>
        <translation>Skalenende</translation>
    </message>
    <message>
        <source>Keep as A</source>
        <translation>Als A behalten</translation>
    </message>
    <message>
        <source>Keeps this run, to compare the next ones with it.</source>
        <translation>Behält diesen Lauf, um die nächsten mit ihm zu vergleichen.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show the whole garment (Home).</source>
        <translation>Das ganze Kleidungsstück zeigen (Pos1).</translation>
    </message>
    <message>
        <source>The steps have ends of their own; Steps… under the legend edits and resets them.</source>
        <translation>Die Stufen haben eigene Enden; Stufen… unter der Legende ändert sie und setzt sie zurück.</translation>
    </message>
    <message>
        <source>About the recording</source>
        <translation>Über die Aufzeichnung</translation>
    </message>
    <message>
        <source>Open Its Design</source>
        <translation>Ihren Entwurf öffnen</translation>
    </message>
    <message>
        <source>Edit the design from which this run was made, in place of the project.</source>
        <translation>Den Entwurf bearbeiten, aus dem dieser Lauf entstand, statt des Projekts.</translation>
    </message>
    <message>
        <source>A recording of “%1” in “%2”, which this project does not hold. It cannot be edited; the forms edit the project.</source>
        <translation>Eine Aufzeichnung von „%1“ in „%2“, die dieses Projekt nicht hat. Sie lässt sich nicht ändern; die Felder ändern das Projekt.</translation>
    </message>
    <message>
        <source>Run that is kept</source>
        <translation>Aufbewahrter Lauf</translation>
    </message>
    <message>
        <source>Where the eight steps of the colours end. Empty: at a round number over the most that the runs hold; while a run goes on, over the most that it is expected to hold.</source>
        <translation>Wo die acht Stufen der Farben enden. Leer: bei einer runden Zahl über dem Höchsten, das die Läufe enthalten; während ein Lauf rechnet, über dem Höchsten, das von ihm zu erwarten ist.</translation>
    </message>
    <message>
        <source>. Cut from another fabric than the project&apos;s garment, as Compare does.</source>
        <translation>. Aus einem anderen Gewebe geschnitten als das Kleidungsstück des Projekts, wie im Vergleich.</translation>
    </message>
    <message>
        <source>. Out of date: the design or the program has changed. Run again.</source>
        <translation>. Veraltet: Der Entwurf oder das Programm hat sich geändert. Rechnen Sie neu.</translation>
    </message>
</context>
<context>
    <name>hygroloom::HelpWindow</name>
    <message>
        <source>Hygroloom User&apos;s Guide</source>
        <translation>Handbuch zu Hygroloom (englisch)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Page of the guide</source>
        <translation>Seite des Handbuchs</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>Lists the pages that have this text. Enter or F3 goes to the next place.</source>
        <translation>Nennt die Seiten, in denen dieser Text steht. Eingabe oder F3 geht zur nächsten Stelle.</translation>
    </message>
    <message>
        <source>Pages with this text</source>
        <translation>Seiten mit diesem Text</translation>
    </message>
    <message>
        <source>Not in the guide.</source>
        <translation>Nicht im Handbuch.</translation>
    </message>
</context>
<context>
    <name>hygroloom::ImportDialog</name>
    <message>
        <source>Import Draft</source>
        <translation>Webbrief importieren</translation>
    </message>
    <message>
        <source>Name of the fabric</source>
        <translation>Name des Gewebes</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>What was understood, and what was repaired</source>
        <translation>Was verstanden und was berichtigt wurde</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Kettfäden</translation>
    </message>
    <message>
        <source>per cm</source>
        <translation>je cm</translation>
    </message>
    <message>
        <source>Picks</source>
        <translation>Schüsse</translation>
    </message>
    <message>
        <source>Warp diameter</source>
        <translation>Durchmesser der Kette</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Weft diameter</source>
        <translation>Durchmesser des Schusses</translation>
    </message>
    <message>
        <source>Use these values from the file:</source>
        <translation>Diese Werte der Datei übernehmen:</translation>
    </message>
    <message>
        <source>The file contains neither sett nor thickness. Set them in the Fabric panel.</source>
        <translation>Die Datei enthält weder Fadendichte noch Dicke. Setzen Sie sie im Feld Gewebe.</translation>
    </message>
    <message>
        <source>Add Fabric</source>
        <translation>Gewebe hinzufügen</translation>
    </message>
    <message>
        <source>Report of the import</source>
        <translation>Bericht über den Import</translation>
    </message>
    <message>
        <source>Understood</source>
        <translation>Verstanden</translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation>Berichtigt</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The cloth in the colours of its yarns</source>
        <translation>Das Gewebe in den Farben seiner Garne</translation>
    </message>
    <message>
        <source>%1 × %2 crossings in one repeat</source>
        <translation>%1 × %2 Kreuzungspunkte je Rapport</translation>
    </message>
    <message>
        <source>%1 shafts</source>
        <translation>%1 Schäfte</translation>
    </message>
    <message>
        <source>%1 more yarns in stripes</source>
        <translation>%1 weitere Garne in Streifen</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source> – doubtful</source>
        <translation> – zweifelhaft</translation>
    </message>
</context>
<context>
    <name>hygroloom::IndicesChart</name>
    <message>
        <source>Sensitivity indices</source>
        <translation>Sensitivitätsindizes</translation>
    </message>
    <message>
        <source>%1: alone %2, with others %3</source>
        <translation>%1: allein %2, mit anderen %3</translation>
    </message>
    <message>
        <source>Not known: too few runs have this metric, or all have the same number.</source>
        <translation>Nicht bekannt: Zu wenige Läufe haben diese Kennzahl, oder alle haben dieselbe.</translation>
    </message>
    <message>
        <source>Compute shows which factors matter.</source>
        <translation>Berechnen zeigt, welche Faktoren wichtig sind.</translation>
    </message>
    <message>
        <source>alone</source>
        <translation>allein</translation>
    </message>
    <message>
        <source>with others</source>
        <translation>mit anderen</translation>
    </message>
</context>
<context>
    <name>hygroloom::IndicesView</name>
    <message>
        <source>Co&amp;mpute</source>
        <translation>Bere&amp;chnen</translation>
    </message>
    <message>
        <source>What the indices rest on</source>
        <translation>Worauf die Indizes beruhen</translation>
    </message>
    <message>
        <source>Metric of the indices</source>
        <translation>Kennzahl der Indizes</translation>
    </message>
    <message>
        <source>Compute the indices from the study&apos;s results.</source>
        <translation>Die Indizes aus den Ergebnissen der Studie berechnen.</translation>
    </message>
    <message>
        <source>Metric:</source>
        <translation>Kennzahl:</translation>
    </message>
    <message>
        <source>Co&amp;mpute Anew</source>
        <translation>Neu bere&amp;chnen</translation>
    </message>
    <message>
        <source>Alone: the share of the variance that a factor makes by itself. With others: with all that it does together with other factors. Whiskers: 95 %. Method: %1, %2 points.</source>
        <translation>Allein: der Anteil an der Varianz, den ein Faktor für sich bewirkt. Mit anderen: mit allem, was er zusammen mit anderen Faktoren bewirkt. Striche: 95 %. Verfahren: %1, %2 Punkte.</translation>
    </message>
</context>
<context>
    <name>hygroloom::IssuesPanel</name>
    <message>
        <source>warp</source>
        <translation>Kette</translation>
    </message>
    <message>
        <source>weft</source>
        <translation>Schuss</translation>
    </message>
    <message>
        <source>yarn %1 (extra yarn %2)</source>
        <translation>Garn %1 (weiteres Garn %2)</translation>
    </message>
    <message>
        <source>droplet %1</source>
        <translation>Tropfen %1</translation>
    </message>
    <message>
        <source>initial climate</source>
        <translation>Klima am Anfang</translation>
    </message>
    <message>
        <source>climate, row %1</source>
        <translation>Klima, Zeile %1</translation>
    </message>
    <message>
        <source>Fabric %1</source>
        <translation>Gewebe %1</translation>
    </message>
    <message>
        <source>Experiment %1</source>
        <translation>Versuch %1</translation>
    </message>
    <message>
        <source>Liquid %1</source>
        <translation>Flüssigkeit %1</translation>
    </message>
    <message>
        <source>Material %1</source>
        <translation>Werkstoff %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>No issues.</source>
        <translation>Keine Meldungen.</translation>
    </message>
    <message>
        <source>Issues of the project</source>
        <translation>Meldungen zum Projekt</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
</context>
<context>
    <name>hygroloom::Lesson</name>
    <message>
        <source>No drop so far.</source>
        <translation>Noch kein Tropfen.</translation>
    </message>
    <message>
        <source>%1 in the yarns</source>
        <translation>%1 in den Garnen</translation>
    </message>
    <message>
        <source>%1 of the yarns’ own vapour gone</source>
        <translation>%1 vom eigenen Dampf der Garne fort</translation>
    </message>
    <message>
        <source>%1 in the fibres</source>
        <translation>%1 in den Fasern</translation>
    </message>
    <message>
        <source>%1 of the fibres’ own water gone</source>
        <translation>%1 vom eigenen Wasser der Fasern fort</translation>
    </message>
    <message>
        <source>%1 in the air</source>
        <translation>%1 in der Luft</translation>
    </message>
    <message>
        <source>%1 more came from the air</source>
        <translation>%1 kamen aus der Luft dazu</translation>
    </message>
    <message>
        <source>%1 still standing</source>
        <translation>%1 stehen noch</translation>
    </message>
    <message>
        <source>%1 run off</source>
        <translation>%1 abgelaufen</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between shares of water</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>Of 1 drop: %1.</source>
        <translation>Von 1 Tropfen: %1.</translation>
    </message>
    <message>
        <source>Of %1 drops: %2.</source>
        <translation>Von %1 Tropfen: %2.</translation>
    </message>
    <message>
        <source>Wet area %1 mm²</source>
        <translation>Nasse Fläche %1 mm²</translation>
    </message>
    <message>
        <source>Radius %1 mm</source>
        <translation>Radius %1 mm</translation>
    </message>
    <message>
        <source>Absorbed in %1 s</source>
        <translation>Aufgenommen in %1 s</translation>
    </message>
    <message>
        <source>Not absorbed yet</source>
        <translation>Noch nicht aufgenommen</translation>
    </message>
    <message>
        <source>No drop to absorb</source>
        <translation>Kein Tropfen aufzunehmen</translation>
    </message>
    <message>
        <source>On a real cloth 1 drop would run down; here it stays.</source>
        <translation>Auf einem echten Stoff liefe 1 Tropfen herab; hier bleibt er.</translation>
    </message>
    <message>
        <source>On a real cloth %1 drops would run down; here they stay.</source>
        <translation>Auf einem echten Stoff liefen %1 Tropfen herab; hier bleiben sie.</translation>
    </message>
    <message>
        <source>Pores: %1 % full</source>
        <translation>Poren: zu %1 % voll</translation>
    </message>
    <message>
        <source>Fibres: %1 % water</source>
        <translation>Fasern: %1 % Wasser</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>The last drop was wiped off</source>
        <translation>Der letzte Tropfen wurde weggewischt</translation>
    </message>
    <message>
        <source>Vapour out: %1 g/(m² h)</source>
        <translation>Dampf hinaus: %1 g/(m² h)</translation>
    </message>
    <message>
        <source>Vapour in: %1 g/(m² h)</source>
        <translation>Dampf herein: %1 g/(m² h)</translation>
    </message>
</context>
<context>
    <name>hygroloom::LessonControls</name>
    <message>
        <source>Drop</source>
        <translation>Tropfen</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>Feuchte</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>The lower edges of the cloths go down. Water in the yarns follows; drops that stand stay where they are.</source>
        <translation>Die unteren Kanten der Stoffe sinken. Wasser in den Garnen folgt; stehende Tropfen bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>%1 µl</source>
        <translation>%1 µl</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
</context>
<context>
    <name>hygroloom::LessonScene</name>
    <message>
        <source>Table with cloths</source>
        <translation>Tisch mit Stoffen</translation>
    </message>
    <message>
        <source>This cloth is being laid out.</source>
        <translation>Dieser Stoff wird ausgelegt.</translation>
    </message>
    <message>
        <source>This cloth is not simulated any more. %1</source>
        <translation>Dieses Gewebe wird nicht weiter simuliert. %1</translation>
    </message>
    <message>
        <source>1 to 4 choose a cloth, arrows move the marker on it, Enter drops water there.</source>
        <translation>1 bis 4 wählen ein Gewebe, Pfeile bewegen die Marke darauf, die Eingabetaste lässt dort Wasser fallen.</translation>
    </message>
</context>
<context>
    <name>hygroloom::LessonSteps</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Seen.</source>
        <translation>Gesehen.</translation>
    </message>
</context>
<context>
    <name>hygroloom::LessonWindow</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Slow motion</source>
        <translation>Zeitlupe</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Explain</source>
        <translation>Erklären</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Lesson – Hygroloom</source>
        <translation>Lektion – Hygroloom</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Contact angle</source>
        <translation>Randwinkel</translation>
    </message>
    <message>
        <source>Weave</source>
        <translation>Bindung</translation>
    </message>
    <message>
        <source>Fibre</source>
        <translation>Faser</translation>
    </message>
    <message>
        <source>Climate</source>
        <translation>Klima</translation>
    </message>
    <message>
        <source>Garment</source>
        <translation>Kleidungsstück</translation>
    </message>
    <message>
        <source>Cloths of my own…</source>
        <translation>Eigene Stoffe…</translation>
    </message>
    <message>
        <source>Lesson from a file…</source>
        <translation>Lektion aus einer Datei…</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>Cloths of my own</source>
        <translation>Eigene Stoffe</translation>
    </message>
    <message>
        <source>Open Lesson</source>
        <translation>Lektion öffnen</translation>
    </message>
    <message>
        <source>Lessons (*.json)</source>
        <translation>Lektionen (*.json)</translation>
    </message>
    <message>
        <source>%1 – Hygroloom</source>
        <translation>%1 – Hygroloom</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>The cloths are being laid out.</source>
        <translation>Die Stoffe werden ausgelegt.</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pausiert</translation>
    </message>
    <message>
        <source>This machine follows at %1 of real time.</source>
        <translation>Dieser Rechner folgt mit dem %1-fachen der wirklichen Zeit.</translation>
    </message>
    <message>
        <source>Ten times slower than real</source>
        <translation>Zehnmal langsamer als wirklich</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Wirkliche Zeit</translation>
    </message>
    <message>
        <source>Recording of %1…</source>
        <translation>Aufzeichnung von %1…</translation>
    </message>
    <message>
        <source>End Film</source>
        <translation>Film beenden</translation>
    </message>
    <message>
        <source>Film as Pictures (PNG)…</source>
        <translation>Film als Bilder (PNG)…</translation>
    </message>
    <message>
        <source>Film (MP4)…</source>
        <translation>Film (MP4)…</translation>
    </message>
    <message>
        <source>Save Recording</source>
        <translation>Aufzeichnung sichern</translation>
    </message>
    <message>
        <source>Recordings (*.hygrorec)</source>
        <translation>Aufzeichnungen (*.hygrorec)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gesichert.</translation>
    </message>
    <message>
        <source>Save Film</source>
        <translation>Film sichern</translation>
    </message>
    <message>
        <source>Films (*.mp4)</source>
        <translation>Filme (*.mp4)</translation>
    </message>
    <message>
        <source>Folder for the Pictures</source>
        <translation>Ordner für die Bilder</translation>
    </message>
    <message>
        <source>The table is being filmed. Save ▸ End Film ends it.</source>
        <translation>Der Tisch wird gefilmt. Sichern ▸ Film beenden beendet das.</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>A film is being taken; it goes on with the new cloths.</source>
        <translation>Ein Film wird aufgenommen; er geht mit den neuen Geweben weiter.</translation>
    </message>
    <message>
        <source>What the drops have come to is lost, unless a recording is saved before. The film goes on with the new cloths.</source>
        <translation>Was aus den Tropfen geworden ist, geht verloren, wenn Sie nicht vorher eine Aufzeichnung speichern. Der Film geht mit den neuen Geweben weiter.</translation>
    </message>
    <message>
        <source>What the drops have come to is lost, unless a recording is saved before.</source>
        <translation>Was aus den Tropfen geworden ist, geht verloren, wenn Sie nicht vorher eine Aufzeichnung speichern.</translation>
    </message>
    <message>
        <source>Lay out new cloths?</source>
        <translation>Neue Gewebe auslegen?</translation>
    </message>
    <message>
        <source>Another lesson</source>
        <translation>Andere Lektion</translation>
    </message>
    <message>
        <source>&amp;Lay Out</source>
        <translation>Aus&amp;legen</translation>
    </message>
    <message>
        <source>The film is being written…</source>
        <translation>Der Film wird geschrieben …</translation>
    </message>
    <message>
        <source>%1 is there already. Replace it?</source>
        <translation>%1 ist schon da. Ersetzen?</translation>
    </message>
    <message>
        <source>What is in that file is lost.</source>
        <translation>Was in dieser Datei steht, geht verloren.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>The film is being written; then the lesson ends.</source>
        <translation>Der Film wird geschrieben; danach endet die Lektion.</translation>
    </message>
    <message>
        <source>The film is being written</source>
        <translation>Der Film wird geschrieben</translation>
    </message>
    <message>
        <source>Leave without the film?</source>
        <translation>Ohne den Film gehen?</translation>
    </message>
    <message>
        <source>What was filmed is lost.</source>
        <translation>Was gefilmt wurde, geht verloren.</translation>
    </message>
    <message>
        <source>&amp;Leave</source>
        <translation>&amp;Gehen</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Ausdrücken</translation>
    </message>
    <message>
        <source>All cloths are squeezed for a moment, so that their pores keep %1 % of their room. Liquid that has no place, and drops that stand, run off. Key: %2</source>
        <translation>Alle Stoffe werden einen Augenblick lang gedrückt, sodass ihre Poren %1 % ihres Raums behalten. Was keinen Platz hat, läuft ab, und ebenso stehende Tropfen. Taste: %2</translation>
    </message>
</context>
<context>
    <name>hygroloom::LiningField</name>
    <message>
        <source>not alike</source>
        <translation>nicht gleich</translation>
    </message>
    <message>
        <source>Lining of all panels</source>
        <translation>Futter aller Schnittteile</translation>
    </message>
    <message>
        <source>Lining of %1</source>
        <translation>Futter von %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>the same fabric</source>
        <translation>derselbe Stoff</translation>
    </message>
    <message>
        <source>A second layer of cloth under the first, on the skin. Choose a panel in the table to line it alone.</source>
        <translation>Eine zweite Lage Stoff unter der ersten, auf der Haut. Wählen Sie ein Schnittteil in der Tabelle, um nur dieses zu füttern.</translation>
    </message>
    <message>
        <source>%1 layers.</source>
        <translation>%1 Lagen.</translation>
    </message>
    <message>
        <source>line all panels</source>
        <translation>alle Schnittteile füttern</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>%1 füttern</translation>
    </message>
    <message>
        <source>Lining</source>
        <translation>Futter</translation>
    </message>
</context>
<context>
    <name>hygroloom::LiquidPanel</name>
    <message>
        <source>Liquid</source>
        <translation>Flüssigkeit</translation>
    </message>
    <message>
        <source>liquid</source>
        <translation>Flüssigkeit</translation>
    </message>
    <message>
        <source>About the liquid</source>
        <translation>Über die Flüssigkeit</translation>
    </message>
    <message>
        <source>Liquids of the project</source>
        <translation>Flüssigkeiten des Projekts</translation>
    </message>
    <message>
        <source>Liquid of the project</source>
        <translation>Flüssigkeit des Projekts</translation>
    </message>
    <message>
        <source>Add a liquid like the experiment&apos;s, and use it</source>
        <translation>Eine Flüssigkeit wie die des Versuchs hinzufügen und verwenden</translation>
    </message>
    <message>
        <source>Duplicate the liquid</source>
        <translation>Die Flüssigkeit duplizieren</translation>
    </message>
    <message>
        <source>Rename the liquid</source>
        <translation>Die Flüssigkeit umbenennen</translation>
    </message>
    <message>
        <source>Delete the liquid</source>
        <translation>Die Flüssigkeit löschen</translation>
    </message>
    <message>
        <source>Experiments that use the liquid</source>
        <translation>Versuche, die die Flüssigkeit verwenden</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (fehlt)</translation>
    </message>
    <message>
        <source>%1, %2, %3 at 20 °C</source>
        <translation>%1, %2, %3 bei 20 °C</translation>
    </message>
    <message>
        <source>The project has no liquid of this name. Choose another.</source>
        <translation>Das Projekt hat keine Flüssigkeit dieses Namens. Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>None yet. Add one to choose its surface tension, viscosity and density.</source>
        <translation>Noch keine. Fügen Sie eine hinzu, um Oberflächenspannung, Viskosität und Dichte zu wählen.</translation>
    </message>
    <message>
        <source>No experiment uses it.</source>
        <translation>Kein Versuch verwendet sie.</translation>
    </message>
    <message>
        <source>Used by %1.</source>
        <translation>Verwendet von %1.</translation>
    </message>
    <message>
        <source>add liquid</source>
        <translation>Flüssigkeit hinzufügen</translation>
    </message>
    <message>
        <source>duplicate liquid</source>
        <translation>Flüssigkeit duplizieren</translation>
    </message>
    <message>
        <source>A liquid needs a name.</source>
        <translation>Eine Flüssigkeit braucht einen Namen.</translation>
    </message>
    <message>
        <source>A liquid “%1” already exists. Choose another name.</source>
        <translation>Eine Flüssigkeit „%1“ gibt es schon. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>rename liquid</source>
        <translation>Flüssigkeit umbenennen</translation>
    </message>
    <message>
        <source>delete liquid</source>
        <translation>Flüssigkeit löschen</translation>
    </message>
    <message>
        <source>Rename liquid</source>
        <translation>Flüssigkeit umbenennen</translation>
    </message>
    <message>
        <source>Delete liquid</source>
        <translation>Flüssigkeit löschen</translation>
    </message>
    <message>
        <source>“%1” is used by %2. They will use %3 instead.</source>
        <translation>„%1“ wird von %2 verwendet. Stattdessen wird dort %3 verwendet.</translation>
    </message>
    <message>
        <source>the library&apos;s liquid of the same name</source>
        <translation>die Flüssigkeit gleichen Namens aus der Bibliothek</translation>
    </message>
    <message>
        <source>water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>„%1“ löschen?</translation>
    </message>
</context>
<context>
    <name>hygroloom::LiveAnswer</name>
    <message>
        <source>Not enough memory for this experiment. Choose a smaller sample.</source>
        <translation>Der Speicher reicht für diesen Versuch nicht. Wählen Sie eine kleinere Probe.</translation>
    </message>
</context>
<context>
    <name>hygroloom::LivePanel</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Refine when I pause</source>
        <translation>Verfeinern, wenn ich pausiere</translation>
    </message>
    <message>
        <source>What the map shows</source>
        <translation>Was die Karte zeigt</translation>
    </message>
    <message>
        <source>After a second without an edit the whole experiment runs at draft, then at standard.</source>
        <translation>Nach einer Sekunde ohne Änderung läuft der ganze Versuch als Entwurf, dann als Standard.</translation>
    </message>
    <message>
        <source>Add an experiment to see its water here.</source>
        <translation>Fügen Sie einen Versuch hinzu, um hier sein Wasser zu sehen.</translation>
    </message>
    <message>
        <source>Add a fabric to see its water here.</source>
        <translation>Fügen Sie ein Gewebe hinzu, um hier sein Wasser zu sehen.</translation>
    </message>
    <message>
        <source>The fabric has an error. Mend it to see its water here.</source>
        <translation>Das Gewebe hat einen Fehler. Beheben Sie ihn, um hier sein Wasser zu sehen.</translation>
    </message>
    <message>
        <source>Off while this machine runs on its battery.</source>
        <translation>Aus, solange dieser Rechner mit der Batterie läuft.</translation>
    </message>
    <message>
        <source>The whole follows.</source>
        <translation>Das Ganze folgt.</translation>
    </message>
    <message>
        <source>Draft is being computed.</source>
        <translation>Entwurf wird gerechnet.</translation>
    </message>
    <message>
        <source>Standard is being computed.</source>
        <translation>Standard wird gerechnet.</translation>
    </message>
    <message>
        <source>%1: %2, %3; %4.</source>
        <translation>%1: %2, %3; %4.</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>nach %1</translation>
    </message>
    <message>
        <source>after %1 of %2</source>
        <translation>nach %1 von %2</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>g/m²</source>
        <translation>g/m²</translation>
    </message>
    <message>
        <source>%1, on the lower %2 of the strip</source>
        <translation>%1, auf den unteren %2 des Streifens</translation>
    </message>
    <message>
        <source>%1, on the middle %2 × %3</source>
        <translation>%1, auf %2 × %3 in der Mitte</translation>
    </message>
    <message>
        <source>The answer follows.</source>
        <translation>Die Antwort folgt.</translation>
    </message>
    <message>
        <source>20 frames, numerical error not known</source>
        <translation>20 Bilder, numerischer Fehler nicht bekannt</translation>
    </message>
    <message>
        <source>Computing. Hatched: the cloth before.</source>
        <translation>Wird berechnet. Schraffiert: das Gewebe davor.</translation>
    </message>
    <message>
        <source>Indices and grades need the whole test.</source>
        <translation>Kennzahlen und Noten brauchen die ganze Prüfung.</translation>
    </message>
</context>
<context>
    <name>hygroloom::MainWindow</name>
    <message>
        <source>Issues</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 ist gespeichert</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Ohne Titel</translation>
    </message>
    <message>
        <source>%1[*] – Hygroloom</source>
        <translation>%1[*] – Hygroloom</translation>
    </message>
    <message>
        <source>This project has no fabric. Add one with Fabric ▸ Add Fabric.</source>
        <translation>Dieses Projekt hat kein Gewebe. Fügen Sie eines mit Gewebe ▸ Gewebe hinzufügen hinzu.</translation>
    </message>
    <message>
        <source>Out of date: %1</source>
        <translation>Veraltet: %1</translation>
    </message>
    <message>
        <source>1 error</source>
        <translation>1 Fehler</translation>
    </message>
    <message>
        <source>%1 errors</source>
        <translation>%1 Fehler</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 Warnung</translation>
    </message>
    <message>
        <source>%1 warnings</source>
        <translation>%1 Warnungen</translation>
    </message>
    <message>
        <source>1 note</source>
        <translation>1 Hinweis</translation>
    </message>
    <message>
        <source>%1 notes</source>
        <translation>%1 Hinweise</translation>
    </message>
    <message>
        <source>No issues</source>
        <translation>Keine Meldungen</translation>
    </message>
    <message>
        <source>Issues: %1</source>
        <translation>Meldungen: %1</translation>
    </message>
    <message>
        <source>Show or hide the issues of the project.</source>
        <translation>Die Meldungen zum Projekt zeigen oder verbergen.</translation>
    </message>
    <message>
        <source>F&amp;abric</source>
        <translation>&amp;Gewebe</translation>
    </message>
    <message>
        <source>E&amp;xperiment</source>
        <translation>&amp;Versuch</translation>
    </message>
    <message>
        <source>&amp;Garment</source>
        <translation>&amp;Kleidung</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New Project</source>
        <translation>&amp;Neues Projekt</translation>
    </message>
    <message>
        <source>Start with a plain-weave fabric and one droplet.</source>
        <translation>Mit einem Gewebe in Leinwandbindung und einem Tropfen beginnen.</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a project or a recording.</source>
        <translation>Ein Projekt oder eine Aufzeichnung öffnen.</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Examples</source>
        <translation>&amp;Beispiele</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the project.</source>
        <translation>Das Projekt speichern.</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save the project under another name.</source>
        <translation>Das Projekt unter einem anderen Namen speichern.</translation>
    </message>
    <message>
        <source>&amp;Import Draft…</source>
        <translation>Webbrief &amp;importieren…</translation>
    </message>
    <message>
        <source>Add a fabric from a WIF draft, a text grid or a picture.</source>
        <translation>Ein Gewebe aus einem WIF-Webbrief, einem Textraster oder einem Bild hinzufügen.</translation>
    </message>
    <message>
        <source>E&amp;xport Draft (WIF)…</source>
        <translation>Webbrief e&amp;xportieren (WIF)…</translation>
    </message>
    <message>
        <source>Write the selected fabric&apos;s draft for other weaving programs.</source>
        <translation>Den Webbrief des gewählten Gewebes für andere Webprogramme schreiben.</translation>
    </message>
    <message>
        <source>Export &amp;Mesh…</source>
        <translation>Ne&amp;tz exportieren…</translation>
    </message>
    <message>
        <source>Write yarns or fibres for modelling and rendering programs.</source>
        <translation>Garne oder Fasern für Modellier- und Darstellungsprogramme schreiben.</translation>
    </message>
    <message>
        <source>Save &amp;Picture…</source>
        <translation>Bi&amp;ld speichern…</translation>
    </message>
    <message>
        <source>Save the fabric or garment as it is seen, or in Compare the maps side by side, as a PNG file.</source>
        <translation>Gewebe oder Kleidungsstück, wie es zu sehen ist, im Vergleich die Karten nebeneinander, als PNG-Datei speichern.</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>B&amp;eenden</translation>
    </message>
    <message>
        <source>Close the window.</source>
        <translation>Das Fenster schließen.</translation>
    </message>
    <message>
        <source>&amp;Mao et al.: Hygroscopicity of Woven Textiles</source>
        <translation>&amp;Mao u. a.: Hygroskopizität von Geweben</translation>
    </message>
    <message>
        <source>The experiments of Mao et al., “Yarn-Level Simulation of Hygroscopicity of Woven Textiles”.</source>
        <translation>Die Versuche von Mao u. a., „Yarn-Level Simulation of Hygroscopicity of Woven Textiles“.</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig:</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen:</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Colour &amp;Range</source>
        <translation>Farb&amp;bereich</translation>
    </message>
    <message>
        <source>Full: 0 to 100 %</source>
        <translation>Voll: 0 bis 100 %</translation>
    </message>
    <message>
        <source>Follow the run</source>
        <translation>Dem Lauf folgen</translation>
    </message>
    <message>
        <source>Follow the time shown</source>
        <translation>Der gezeigten Zeit folgen</translation>
    </message>
    <message>
        <source>&amp;Water Colours</source>
        <translation>&amp;Wasserfarben</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Aussehen</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Felder</translation>
    </message>
    <message>
        <source>R&amp;eset Layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Restore the original arrangement of the panels.</source>
        <translation>Die ursprüngliche Anordnung der Felder wiederherstellen.</translation>
    </message>
    <message>
        <source>&amp;Design</source>
        <translation>&amp;Entwerfen</translation>
    </message>
    <message>
        <source>Edit the fabric.</source>
        <translation>Das Gewebe bearbeiten.</translation>
    </message>
    <message>
        <source>Compare runs of the same experiment side by side.</source>
        <translation>Läufe desselben Versuchs nebeneinander vergleichen.</translation>
    </message>
    <message>
        <source>Cut a garment from fabrics, and wear it.</source>
        <translation>Ein Kleidungsstück aus Geweben zuschneiden und tragen.</translation>
    </message>
    <message>
        <source>Run many points, and see what matters.</source>
        <translation>Viele Punkte rechnen und sehen, worauf es ankommt.</translation>
    </message>
    <message>
        <source>As the &amp;Desktop</source>
        <translation>Wie die &amp;Arbeitsfläche</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>High &amp;Contrast</source>
        <translation>Hoher &amp;Kontrast</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;User&apos;s Guide</source>
        <translation>&amp;Handbuch (englisch)</translation>
    </message>
    <message>
        <source>Explain this workspace or experiment.</source>
        <translation>Diesen Arbeitsbereich oder Versuch erklären.</translation>
    </message>
    <message>
        <source>&amp;Find Command…</source>
        <translation>&amp;Befehl suchen…</translation>
    </message>
    <message>
        <source>Find a command by letters of its name.</source>
        <translation>Einen Befehl nach Buchstaben seines Namens finden.</translation>
    </message>
    <message>
        <source>&amp;About Hygroloom</source>
        <translation>&amp;Über Hygroloom</translation>
    </message>
    <message>
        <source>Version and licence.</source>
        <translation>Version und Lizenz.</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Über &amp;Qt</translation>
    </message>
    <message>
        <source>The toolkit of this program.</source>
        <translation>Der Werkzeugkasten dieses Programms.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Workspace %1</source>
        <translation>Arbeitsbereich %1</translation>
    </message>
    <message>
        <source>About Hygroloom</source>
        <translation>Über Hygroloom</translation>
    </message>
    <message>
        <source>Simulates how woven fabrics take up, spread and dry water.</source>
        <translation>Simuliert, wie Gewebe Wasser aufnehmen, verteilen und trocknen.</translation>
    </message>
    <message>
        <source>This program is free software under the GNU General Public License, version 3 or later, with an additional permission to link with the CUDA runtime. It comes with no warranty, to the extent the law permits.</source>
        <translation>Dieses Programm ist freie Software unter der GNU General Public License, Version 3 oder später, mit der zusätzlichen Erlaubnis, es mit der CUDA-Laufzeitbibliothek zu verbinden. Es gibt keine Gewähr, soweit das Gesetz es erlaubt.</translation>
    </message>
    <message>
        <source>Unsaved work found</source>
        <translation>Ungespeicherte Arbeit gefunden</translation>
    </message>
    <message>
        <source>Hygroloom ended before “%1” was saved. Open the recovered copy?</source>
        <translation>Hygroloom endete, bevor „%1“ gespeichert war. Die wiederhergestellte Kopie öffnen?</translation>
    </message>
    <message>
        <source>Last changed on %1.</source>
        <translation>Zuletzt geändert am %1.</translation>
    </message>
    <message>
        <source>The file %1 was changed since. The recovered copy opens separately and asks for a name when you save it.</source>
        <translation>Die Datei %1 wurde seither geändert. Die wiederhergestellte Kopie öffnet sich getrennt und fragt beim Speichern nach einem Namen.</translation>
    </message>
    <message>
        <source>1 run belongs to it.</source>
        <translation>1 Lauf gehört dazu.</translation>
    </message>
    <message>
        <source>%1 runs belong to it.</source>
        <translation>%1 Läufe gehören dazu.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Ask Again Later</source>
        <translation>Später &amp;wieder fragen</translation>
    </message>
    <message>
        <source>one drop</source>
        <translation>ein Tropfen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Projects and recordings (*.hygro *.hygrorec);;All files (*)</source>
        <translation>Projekte und Aufzeichnungen (*.hygro *.hygrorec);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Projects (*.hygro)</source>
        <translation>Projekte (*.hygro)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>There is no garment to save a picture of. Add one.</source>
        <translation>Es gibt kein Kleidungsstück, von dem ein Bild zu speichern wäre. Fügen Sie eines hinzu.</translation>
    </message>
    <message>
        <source>No runs are compared, so there is no picture to save. Tick the runs in the list.</source>
        <translation>Es werden keine Läufe verglichen, daher gibt es kein Bild zu speichern. Kreuzen Sie die Läufe in der Liste an.</translation>
    </message>
    <message>
        <source>This display cannot draw the fabric, so there is no picture to save.</source>
        <translation>Diese Anzeige kann das Gewebe nicht zeichnen, daher gibt es kein Bild zu speichern.</translation>
    </message>
    <message>
        <source>study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>garment</source>
        <translation>Kleidungsstück</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>The picture cannot be written to %1.</source>
        <translation>Das Bild lässt sich nicht in %1 schreiben.</translation>
    </message>
    <message>
        <source>Import Draft</source>
        <translation>Webbrief importieren</translation>
    </message>
    <message>
        <source>Drafts, text grids and pictures (*.wif *.txt *.png *.bmp);;All files (*)</source>
        <translation>Webbriefe, Textraster und Bilder (*.wif *.txt *.png *.bmp);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>import of %1</source>
        <translation>Import von %1</translation>
    </message>
    <message>
        <source>This fabric has an error and its draft cannot be exported. See the Issues panel.</source>
        <translation>Dieses Gewebe hat einen Fehler, und sein Webbrief lässt sich nicht exportieren. Siehe das Feld Meldungen.</translation>
    </message>
    <message>
        <source>Export Draft</source>
        <translation>Webbrief exportieren</translation>
    </message>
    <message>
        <source>Drafts (*.wif)</source>
        <translation>Webbriefe (*.wif)</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Runs are not saved</source>
        <translation>Läufe sind nicht gespeichert</translation>
    </message>
    <message>
        <source>Save the project, so that its runs are kept beside it?</source>
        <translation>Das Projekt speichern, damit seine Läufe bei ihm bleiben?</translation>
    </message>
    <message>
        <source>Otherwise these runs are deleted:</source>
        <translation>Sonst werden diese Läufe gelöscht:</translation>
    </message>
    <message>
        <source>&amp;Delete the Run</source>
        <translation>Lauf &amp;löschen</translation>
    </message>
    <message>
        <source>&amp;Delete the Runs</source>
        <translation>Läufe &amp;löschen</translation>
    </message>
    <message>
        <source>Runs are being copied to the project.</source>
        <translation>Läufe werden zum Projekt kopiert.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>Copying runs</source>
        <translation>Läufe werden kopiert</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Die Änderungen an „%1“ speichern?</translation>
    </message>
    <message>
        <source>Otherwise they are lost.</source>
        <translation>Sonst gehen sie verloren.</translation>
    </message>
    <message>
        <source>An export is in progress</source>
        <translation>Ein Export ist im Gang</translation>
    </message>
    <message>
        <source>Stop the export?</source>
        <translation>Den Export stoppen?</translation>
    </message>
    <message>
        <source>No file will be written.</source>
        <translation>Es wird keine Datei geschrieben.</translation>
    </message>
    <message>
        <source>Stop the Export</source>
        <translation>Export stoppen</translation>
    </message>
    <message>
        <source>S&amp;tart Page…</source>
        <translation>St&amp;artseite…</translation>
    </message>
    <message>
        <source>Choose among recent projects, examples and fabrics.</source>
        <translation>Unter letzten Projekten, Beispielen und Stoffen wählen.</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Units, look, mouse, autosave, runs, devices.</source>
        <translation>Einheiten, Aussehen, Maus, Sicherungskopien, Läufe, Geräte.</translation>
    </message>
    <message>
        <source>&amp;Lesson</source>
        <translation>Lektio&amp;n</translation>
    </message>
    <message>
        <source>Drop water on cloths with a class, on the whole screen.</source>
        <translation>Mit einer Klasse Wasser auf Stoffe tropfen, auf dem ganzen Bildschirm.</translation>
    </message>
    <message>
        <source>The runs of this project take more than %1 GB. Delete the oldest that are not marked Keep?</source>
        <translation>Die Läufe dieses Projekts belegen mehr als %1 GB. Die ältesten löschen, die nicht mit Behalten markiert sind?</translation>
    </message>
    <message>
        <source>This frees %1. Edit ▸ Preferences ▸ Runs sets how much room runs may take.</source>
        <translation>Das gibt %1 frei. Bearbeiten ▸ Einstellungen ▸ Läufe legt fest, wie viel Platz Läufe belegen dürfen.</translation>
    </message>
    <message>
        <source>Runs take much room</source>
        <translation>Läufe belegen viel Platz</translation>
    </message>
    <message>
        <source>&amp;Save the Project</source>
        <translation>Projekt &amp;speichern</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Discard the Changes</source>
        <translation>Änderungen &amp;verwerfen</translation>
    </message>
    <message>
        <source>A film is being written</source>
        <translation>Ein Film wird geschrieben</translation>
    </message>
    <message>
        <source>Finish the film before Hygroloom closes?</source>
        <translation>Den Film fertigstellen, bevor Hygroloom schließt?</translation>
    </message>
    <message>
        <source>Without that, what was filmed is lost.</source>
        <translation>Sonst geht verloren, was gefilmt wurde.</translation>
    </message>
    <message>
        <source>&amp;Finish the Film</source>
        <translation>Film &amp;fertigstellen</translation>
    </message>
    <message>
        <source>&amp;Leave without It</source>
        <translation>&amp;Ohne ihn gehen</translation>
    </message>
    <message>
        <source>The file was changed</source>
        <translation>Die Datei wurde geändert</translation>
    </message>
    <message>
        <source>Replace %1, which another program changed after it was opened here?</source>
        <translation>%1 ersetzen? Ein anderes Programm hat die Datei geändert, nachdem sie hier geöffnet wurde.</translation>
    </message>
    <message>
        <source>The other program&apos;s version is then in %1~, until the project is saved again. Opening it loses what was changed here.</source>
        <translation>Die Fassung des anderen Programms liegt dann in %1~, bis das Projekt wieder gespeichert wird. Wird sie geöffnet, geht verloren, was hier geändert wurde.</translation>
    </message>
    <message>
        <source>&amp;Open the Other Version</source>
        <translation>Andere Fassung ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Replace the File</source>
        <translation>Datei &amp;ersetzen</translation>
    </message>
    <message>
        <source>Keep the Colours of Maps</source>
        <translation>Farben der Karten festhalten</translation>
    </message>
    <message>
        <source>The ends of the colours stay as they are, in all workspaces, whatever is shown.</source>
        <translation>Die Enden der Farben bleiben in allen Arbeitsbereichen, wie sie sind, was auch gezeigt wird.</translation>
    </message>
    <message>
        <source>Fit the Colours of Maps</source>
        <translation>Farben der Karten anpassen</translation>
    </message>
    <message>
        <source>The colours end where the maps that are shown do, in all workspaces.</source>
        <translation>Die Farben enden in allen Arbeitsbereichen dort, wo die gezeigten Karten enden.</translation>
    </message>
    <message>
        <source>Technical Car&amp;d…</source>
        <translation>Tec&amp;hnische Karte…</translation>
    </message>
    <message>
        <source>Show what runs, what waits and why.</source>
        <translation>Zeigen, was läuft, was wartet und warum.</translation>
    </message>
    <message>
        <source>Show the Garment</source>
        <translation>Das Kleidungsstück zeigen</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Rechnen</translation>
    </message>
    <message>
        <source>Run an experiment on a sample or a garment.</source>
        <translation>Einen Versuch an einer Probe oder einem Kleidungsstück rechnen.</translation>
    </message>
    <message>
        <source>Compare runs of the same experiment, or study many points.</source>
        <translation>Läufe desselben Versuchs vergleichen, oder viele Punkte untersuchen.</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>Run an experiment on a sample of the fabric.</source>
        <translation>Einen Versuch an einer Probe des Gewebes rechnen.</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Entwerfen</translation>
    </message>
    <message>
        <source>Run, as Last Shown</source>
        <translation>Rechnen, wie zuletzt gezeigt</translation>
    </message>
    <message>
        <source>Compare, as Last Shown</source>
        <translation>Vergleichen, wie zuletzt gezeigt</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Run: &amp;Garment</source>
        <translation>Rechnen: &amp;Kleidung</translation>
    </message>
    <message>
        <source>Garment</source>
        <translation>Kleidung</translation>
    </message>
    <message>
        <source>Co&amp;mpare: Runs</source>
        <translation>&amp;Vergleichen: Läufe</translation>
    </message>
    <message>
        <source>Compare: S&amp;tudy</source>
        <translation>Vergleichen: St&amp;udie</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Queue of Runs</source>
        <translation>Warteschlange der Läufe</translation>
    </message>
    <message>
        <source>Run: Sample</source>
        <translation>Rechnen: Probe</translation>
    </message>
    <message>
        <source>The laboratory&apos;s numbers of the selected fabric, and its card as a page.</source>
        <translation>Die Laborzahlen des ausgewählten Gewebes und seine Karte als Seite.</translation>
    </message>
</context>
<context>
    <name>hygroloom::NameDialog</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Why the name cannot be taken</source>
        <translation>Warum der Name nicht möglich ist</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
</context>
<context>
    <name>hygroloom::NewestJob</name>
    <message>
        <source>Work in the background ended early: %1</source>
        <translation>Arbeit im Hintergrund endete vorzeitig: %1</translation>
    </message>
    <message>
        <source>the memory did not suffice</source>
        <translation>der Speicher reichte nicht</translation>
    </message>
</context>
<context>
    <name>hygroloom::NumberDelegate</name>
    <message>
        <source>Run</source>
        <translation>Rechnen</translation>
    </message>
</context>
<context>
    <name>hygroloom::OrderEditor</name>
    <message>
        <source>Type counts and yarn letters, such as 12A 4B.</source>
        <translation>Geben Sie Anzahlen und Garnbuchstaben ein, etwa 12A 4B.</translation>
    </message>
    <message>
        <source>There is no yarn %1; the last one is %2.</source>
        <translation>Es gibt kein Garn %1; das letzte ist %2.</translation>
    </message>
    <message>
        <source>Each stripe needs at least 1 yarn; all together at most %1.</source>
        <translation>Jeder Streifen braucht mindestens 1 Garn; alle zusammen höchstens %1.</translation>
    </message>
    <message>
        <source>all A</source>
        <translation>alle A</translation>
    </message>
    <message>
        <source>One repeat of the stripes, such as 12A 4B. A is the fabric&apos;s own yarn. Leave empty for no stripes.</source>
        <translation>Ein Rapport der Streifen, etwa 12A 4B. A ist das eigene Garn des Gewebes. Leer lassen für keine Streifen.</translation>
    </message>
    <message>
        <source>Yarns of the fabric</source>
        <translation>Garne des Gewebes</translation>
    </message>
    <message>
        <source>Select a yarn, then drag over the bars along the draft. Double-click it to edit its fibre, count and twist.</source>
        <translation>Wählen Sie ein Garn und ziehen Sie über die Balken am Webbrief. Ein Doppelklick bearbeitet Faser, Feinheit und Drehung.</translation>
    </message>
    <message>
        <source>Add a yarn like the warp</source>
        <translation>Ein Garn wie die Kette hinzufügen</translation>
    </message>
    <message>
        <source>Remove the selected yarn</source>
        <translation>Das gewählte Garn entfernen</translation>
    </message>
    <message>
        <source>Colour of the selected yarn…</source>
        <translation>Farbe des gewählten Garns…</translation>
    </message>
    <message>
        <source>Order of the ends</source>
        <translation>Folge der Kettfäden</translation>
    </message>
    <message>
        <source>Order of the picks</source>
        <translation>Folge der Schussfäden</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Kettfäden</translation>
    </message>
    <message>
        <source>Picks</source>
        <translation>Schüsse</translation>
    </message>
    <message>
        <source>A  warp | weft</source>
        <translation>A  Kette | Schuss</translation>
    </message>
    <message>
        <source>add yarn</source>
        <translation>Garn hinzufügen</translation>
    </message>
    <message>
        <source>remove yarn</source>
        <translation>Garn entfernen</translation>
    </message>
    <message>
        <source>yarn colour</source>
        <translation>Garnfarbe</translation>
    </message>
    <message>
        <source>Yarn Colour</source>
        <translation>Garnfarbe</translation>
    </message>
    <message>
        <source>order of the ends</source>
        <translation>Folge der Kettfäden</translation>
    </message>
    <message>
        <source>order of the picks</source>
        <translation>Folge der Schussfäden</translation>
    </message>
</context>
<context>
    <name>hygroloom::PairsChart</name>
    <message>
        <source>Two columns against each other</source>
        <translation>Zwei Spalten gegeneinander</translation>
    </message>
    <message>
        <source>Left and Right choose the next row across.</source>
        <translation>Links und Rechts wählen die nächste Zeile waagerecht.</translation>
    </message>
</context>
<context>
    <name>hygroloom::PairsView</name>
    <message>
        <source>Column across</source>
        <translation>Spalte waagerecht</translation>
    </message>
    <message>
        <source>Column upwards</source>
        <translation>Spalte senkrecht</translation>
    </message>
    <message>
        <source>Column that colours</source>
        <translation>Spalte, die färbt</translation>
    </message>
    <message>
        <source>Across:</source>
        <translation>Waagerecht:</translation>
    </message>
    <message>
        <source>Upwards:</source>
        <translation>Senkrecht:</translation>
    </message>
    <message>
        <source>Colour:</source>
        <translation>Farbe:</translation>
    </message>
    <message>
        <source>What the pairs show</source>
        <translation>Was die Paare zeigen</translation>
    </message>
    <message>
        <source>Each point is a row. Click one to choose it; it can then become a candidate.</source>
        <translation>Jeder Punkt ist eine Zeile. Klicken wählt sie; sie kann dann ein Kandidat werden.</translation>
    </message>
</context>
<context>
    <name>hygroloom::PanelTable</name>
    <message>
        <source>Panel</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Top face</source>
        <translation>Oberseite</translation>
    </message>
    <message>
        <source>Angle of the warp from the pattern&apos;s upward direction, counter-clockwise seen from outside.</source>
        <translation>Winkel der Kette zur Aufwärtsrichtung des Schnitts, gegen den Uhrzeigersinn von außen gesehen.</translation>
    </message>
    <message>
        <source>Where the fabric&apos;s top face lies.</source>
        <translation>Wo die Oberseite des Gewebes liegt.</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>Panels of the garment</source>
        <translation>Schnittteile des Kleidungsstücks</translation>
    </message>
    <message>
        <source>Fabric of %1</source>
        <translation>Gewebe von %1</translation>
    </message>
    <message>
        <source>cut %1 from %2</source>
        <translation>%1 aus %2 zuschneiden</translation>
    </message>
    <message>
        <source>Grain of %1</source>
        <translation>Fadenlauf von %1</translation>
    </message>
    <message>
        <source>turn the grain of %1</source>
        <translation>Fadenlauf von %1 drehen</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>Top face of %1</source>
        <translation>Oberseite von %1</translation>
    </message>
    <message>
        <source>turn %1</source>
        <translation>%1 wenden</translation>
    </message>
    <message>
        <source>This panel has no fabric.</source>
        <translation>Dieses Schnittteil hat kein Gewebe.</translation>
    </message>
</context>
<context>
    <name>hygroloom::ParallelChart</name>
    <message>
        <source>Parallel coordinates</source>
        <translation>Parallele Koordinaten</translation>
    </message>
    <message>
        <source>Left and Right choose an axis, Up and Down move its range, with Shift they widen it, Escape keeps all rows.</source>
        <translation>Links und Rechts wählen eine Achse, Auf und Ab verschieben ihren Bereich, mit Umschalt erweitern sie ihn, Escape behält alle Zeilen.</translation>
    </message>
</context>
<context>
    <name>hygroloom::ParallelView</name>
    <message>
        <source>Column that colours the lines</source>
        <translation>Spalte, die die Linien färbt</translation>
    </message>
    <message>
        <source>Show &amp;All Rows</source>
        <translation>&amp;Alle Zeilen zeigen</translation>
    </message>
    <message>
        <source>Take away the ranges on the axes.</source>
        <translation>Die Bereiche auf den Achsen aufheben.</translation>
    </message>
    <message>
        <source>Colour:</source>
        <translation>Farbe:</translation>
    </message>
    <message>
        <source>What the parallel coordinates show</source>
        <translation>Was die parallelen Koordinaten zeigen</translation>
    </message>
    <message>
        <source>Each line is a row. Drag along an axis to keep the rows in that range, here and in the table; a click takes the range away.</source>
        <translation>Jede Linie ist eine Zeile. Ziehen Sie an einer Achse, um hier und in der Tabelle die Zeilen in diesem Bereich zu behalten; ein Klick hebt den Bereich auf.</translation>
    </message>
</context>
<context>
    <name>hygroloom::PartsTable</name>
    <message>
        <source>Numbers per panel and zone</source>
        <translation>Zahlen je Schnittteil und Zone</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Als CSV kopieren</translation>
    </message>
</context>
<context>
    <name>hygroloom::PlanDialog</name>
    <message>
        <source>%1 on %2, %3</source>
        <translation>%1 mit %2, %3</translation>
    </message>
    <message>
        <source>modelled</source>
        <translation>modelliert</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>, set by you</source>
        <translation>, von Ihnen gesetzt</translation>
    </message>
    <message>
        <source>, checked during the run</source>
        <translation>, im Lauf geprüft</translation>
    </message>
    <message>
        <source>Region.</source>
        <translation>Gebiet.</translation>
    </message>
    <message>
        <source>%1 × %2 crossings, %3 yarn segments.</source>
        <translation>%1 × %2 Kreuzungspunkte, %3 Garnabschnitte.</translation>
    </message>
    <message>
        <source>Resolution.</source>
        <translation>Auflösung.</translation>
    </message>
    <message>
        <source>One frame every %1 s.</source>
        <translation>Ein Bild alle %1 s.</translation>
    </message>
    <message>
        <source>Expected.</source>
        <translation>Zu erwarten.</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>under 1 s</source>
        <translation>unter 1 s</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>etwa %1 min</translation>
    </message>
    <message>
        <source>about %1 h</source>
        <translation>etwa %1 h</translation>
    </message>
    <message>
        <source>%1 of %2 simulated in %3 s</source>
        <translation>%1 von %2 in %3 s simuliert</translation>
    </message>
    <message>
        <source>, paused.</source>
        <translation>, pausiert.</translation>
    </message>
    <message>
        <source>, %1 left.</source>
        <translation>, noch %1.</translation>
    </message>
    <message>
        <source>numerical error not known</source>
        <translation>numerischer Fehler nicht bekannt</translation>
    </message>
    <message>
        <source>reference for numerical errors</source>
        <translation>Bezug für numerische Fehler</translation>
    </message>
    <message>
        <source>%1, %2 of memory, %3. %4</source>
        <translation>%1, %2 Speicher, %3. %4</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>expected numerical error not known</source>
        <translation>erwarteter numerischer Fehler nicht bekannt</translation>
    </message>
    <message>
        <source>the reference for numerical errors</source>
        <translation>der Bezug für numerische Fehler</translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation>erwarteter %1</translation>
    </message>
    <message>
        <source>What the next run models, and why</source>
        <translation>Was der nächste Lauf modelliert, und warum</translation>
    </message>
    <message>
        <source>The next run: %1</source>
        <translation>Der nächste Lauf: %1</translation>
    </message>
    <message>
        <source>What was modelled, and why</source>
        <translation>Was modelliert wurde, und warum</translation>
    </message>
    <message>
        <source>The run on screen: %1</source>
        <translation>Der gezeigte Lauf: %1</translation>
    </message>
    <message>
        <source>numerical error about %1 %</source>
        <translation>numerischer Fehler etwa %1 %</translation>
    </message>
    <message>
        <source>%1, error ≈ %2 %</source>
        <translation>%1, Fehler ≈ %2 %</translation>
    </message>
    <message>
        <source>Expected: %1</source>
        <translation>Zu erwarten: %1</translation>
    </message>
</context>
<context>
    <name>hygroloom::Playback</name>
    <message>
        <source>%1 more frames are left out.</source>
        <translation>%1 weitere Bilder sind ausgelassen.</translation>
    </message>
    <message>
        <source>In fibres: water absorbed since the start.
Click to show that time.</source>
        <translation>In Fasern: Wasser, das seit dem Anfang aufgenommen wurde.
Klicken zeigt diese Zeit.</translation>
    </message>
    <message>
        <source>absorbed at %1 s</source>
        <translation>aufgenommen bei %1 s</translation>
    </message>
</context>
<context>
    <name>hygroloom::PointPaper</name>
    <message>
        <source>Weave on point paper</source>
        <translation>Bindung als Patrone</translation>
    </message>
    <message>
        <source>A filled square means the warp end lies over the weft pick. Arrow keys move, with Shift they select, Space uses the tool.</source>
        <translation>Ein gefülltes Feld bedeutet: Der Kettfaden liegt über dem Schuss. Pfeiltasten bewegen, mit Umschalt wählen sie aus, die Leertaste benutzt das Werkzeug.</translation>
    </message>
    <message>
        <source>Scroll along the picks</source>
        <translation>Entlang der Schüsse rollen</translation>
    </message>
    <message>
        <source>Scroll along the ends</source>
        <translation>Entlang der Kettfäden rollen</translation>
    </message>
</context>
<context>
    <name>hygroloom::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Pages of the preferences</source>
        <translation>Seiten der Einstellungen</translation>
    </message>
    <message>
        <source>&amp;Restore Defaults</source>
        <translation>&amp;Vorgaben wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>How numbers are shown. Fields take any unit that is typed with the number.</source>
        <translation>Wie Zahlen gezeigt werden. Felder nehmen jede Einheit, die mit der Zahl eingegeben wird.</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>millimetres (mm)</source>
        <translation>Millimeter (mm)</translation>
    </message>
    <message>
        <source>centimetres (cm)</source>
        <translation>Zentimeter (cm)</translation>
    </message>
    <message>
        <source>inches (in)</source>
        <translation>Zoll (in)</translation>
    </message>
    <message>
        <source>Yarn count</source>
        <translation>Garnfeinheit</translation>
    </message>
    <message>
        <source>tex (g per km)</source>
        <translation>tex (g je km)</translation>
    </message>
    <message>
        <source>English cotton count (Ne)</source>
        <translation>englische Baumwollnummer (Ne)</translation>
    </message>
    <message>
        <source>metric count (Nm)</source>
        <translation>metrische Nummer (Nm)</translation>
    </message>
    <message>
        <source>denier (g per 9 km)</source>
        <translation>Denier (g je 9 km)</translation>
    </message>
    <message>
        <source>Sett</source>
        <translation>Fadendichte</translation>
    </message>
    <message>
        <source>per centimetre</source>
        <translation>je Zentimeter</translation>
    </message>
    <message>
        <source>per inch</source>
        <translation>je Zoll</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>degrees Celsius (°C)</source>
        <translation>Grad Celsius (°C)</translation>
    </message>
    <message>
        <source>degrees Fahrenheit (°F)</source>
        <translation>Grad Fahrenheit (°F)</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Acts at the next start.</source>
        <translation>Wirkt beim nächsten Start.</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Schreibtisch</translation>
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
        <source>Water colours</source>
        <translation>Farben des Wassers</translation>
    </message>
    <message>
        <source>Show the start page at the start</source>
        <translation>Startseite beim Start zeigen</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>In pictures of cloth and of garments.</source>
        <translation>In Bildern von Stoffen und von Kleidungsstücken.</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>forward comes nearer</source>
        <translation>vorwärts kommt näher</translation>
    </message>
    <message>
        <source>backward comes nearer</source>
        <translation>rückwärts kommt näher</translation>
    </message>
    <message>
        <source>Zoom to the pointer, not to the middle</source>
        <translation>Zum Zeiger zoomen, nicht zur Mitte</translation>
    </message>
    <message>
        <source>Autosave</source>
        <translation>Sicherungskopien</translation>
    </message>
    <message>
        <source>A copy of unsaved work outlives a crash and is offered at the next start. Your own file changes only when you save.</source>
        <translation>Eine Kopie ungesicherter Arbeit überlebt einen Absturz und wird beim nächsten Start angeboten. Ihre eigene Datei ändert sich nur, wenn Sie sichern.</translation>
    </message>
    <message>
        <source>Keep a copy every</source>
        <translation>Kopie sichern alle</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>change, at once</source>
        <translation>Änderung, sofort</translation>
    </message>
    <message>
        <source>1 to %1 minutes, or a second after each change.</source>
        <translation>1 bis %1 Minuten, oder eine Sekunde nach jeder Änderung.</translation>
    </message>
    <message>
        <source>A crash loses at most what was changed since the last copy.</source>
        <translation>Ein Absturz verliert höchstens, was seit der letzten Kopie geändert wurde.</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Room for the runs of a project</source>
        <translation>Platz für die Läufe eines Projekts</translation>
    </message>
    <message>
        <source>GB</source>
        <translation>GB</translation>
    </message>
    <message>
        <source>Threads of a run on the CPU</source>
        <translation>Threads eines Laufs auf der CPU</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Cache</source>
        <translation>Zwischenspeicher</translation>
    </message>
    <message>
        <source>C&amp;lear the Cache</source>
        <translation>Zwischenspeicher &amp;leeren</translation>
    </message>
    <message>
        <source>Deletes pictures of the start page, what was found of rooms between yarns and how long runs took. All are made anew.</source>
        <translation>Löscht Bilder der Startseite, gefundene Räume zwischen Garnen und wie lange Läufe dauerten. Alles entsteht neu.</translation>
    </message>
    <message>
        <source>Cache: %1 in %2</source>
        <translation>Zwischenspeicher: %1 in %2</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Processors that runs may be computed on.</source>
        <translation>Prozessoren, auf denen Läufe rechnen können.</translation>
    </message>
    <message>
        <source>For new runs</source>
        <translation>Für neue Läufe</translation>
    </message>
    <message>
        <source>Automatic: a GPU where one can be used</source>
        <translation>Automatisch: eine GPU, wo eine nutzbar ist</translation>
    </message>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>GPU</source>
        <translation>GPU</translation>
    </message>
    <message>
        <source>%1: can be used</source>
        <translation>%1: nutzbar</translation>
    </message>
    <message>
        <source>%1: cannot be used. %2</source>
        <translation>%1: nicht nutzbar. %2</translation>
    </message>
    <message>
        <source>%1 cannot be deleted. Check that the folder can be written to.</source>
        <translation>%1 lässt sich nicht löschen. Prüfen Sie, ob in den Ordner geschrieben werden kann.</translation>
    </message>
    <message>
        <source>Sets all pages to their defaults.</source>
        <translation>Setzt alle Seiten auf ihre Vorgaben.</translation>
    </message>
    <message>
        <source>When a run ends and the runs take more, the window offers to delete the oldest that are not marked Keep.</source>
        <translation>Wenn ein Lauf endet und die Läufe mehr belegen, bietet das Fenster an, die ältesten zu löschen, die nicht mit Behalten markiert sind.</translation>
    </message>
    <message>
        <source>Running simulations keep theirs. Fewer threads leave room for other work.</source>
        <translation>Laufende Simulationen behalten ihre. Weniger Threads lassen Raum für andere Arbeit.</translation>
    </message>
    <message>
        <source>Tables saved as files and the command line keep mm, tex and °C; so do the lesson and scale bars in pictures of reports.</source>
        <translation>Gespeicherte Tabellen und die Kommandozeile behalten mm, tex und °C, ebenso die Lektion und Maßstäbe in Bildern von Berichten.</translation>
    </message>
    <message>
        <source>Refine pictures of cloth while nothing moves</source>
        <translation>Bilder des Gewebes verfeinern, solange sich nichts bewegt</translation>
    </message>
</context>
<context>
    <name>hygroloom::PresetGallery</name>
    <message>
        <source>%1 % %2</source>
        <translation>%1 % %2</translation>
    </message>
    <message>
        <source>, %1 tex</source>
        <translation>, %1 tex</translation>
    </message>
    <message>
        <source>, %1 mm</source>
        <translation>, %1 mm</translation>
    </message>
    <message>
        <source>My library</source>
        <translation>Meine Bibliothek</translation>
    </message>
    <message>
        <source>Saved by you.</source>
        <translation>Von Ihnen gespeichert.</translation>
    </message>
    <message>
        <source>Add a Fabric from the Library</source>
        <translation>Gewebe aus der Bibliothek hinzufügen</translation>
    </message>
    <message>
        <source>Group of fabrics</source>
        <translation>Gruppe von Geweben</translation>
    </message>
    <message>
        <source>Search the library</source>
        <translation>Bibliothek durchsuchen</translation>
    </message>
    <message>
        <source>Search: name, fibre, weave</source>
        <translation>Suche: Name, Faser, Bindung</translation>
    </message>
    <message>
        <source>Fabrics of the library</source>
        <translation>Gewebe der Bibliothek</translation>
    </message>
    <message>
        <source>About the selected fabric</source>
        <translation>Über das gewählte Gewebe</translation>
    </message>
    <message>
        <source>Add Fabric</source>
        <translation>Gewebe hinzufügen</translation>
    </message>
    <message>
        <source>Remove from My Library</source>
        <translation>Aus meiner Bibliothek entfernen</translation>
    </message>
    <message>
        <source>All groups</source>
        <translation>Alle Gruppen</translation>
    </message>
    <message>
        <source>No fabric matches. Use fewer words.</source>
        <translation>Kein Gewebe passt. Nehmen Sie weniger Wörter.</translation>
    </message>
    <message>
        <source>%1 g/m²</source>
        <translation>%1 g/m²</translation>
    </message>
    <message>
        <source>%1 × %2 per cm</source>
        <translation>%1 × %2 je cm</translation>
    </message>
    <message>
        <source>Warp: %1</source>
        <translation>Kette: %1</translation>
    </message>
    <message>
        <source>Weft: %1</source>
        <translation>Schuss: %1</translation>
    </message>
</context>
<context>
    <name>hygroloom::ProjectRuns</name>
    <message>
        <source>cannot be read</source>
        <translation>lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>%1 cannot be read; Runs lists why.</source>
        <translation>%1 lässt sich nicht lesen; Läufe nennt den Grund.</translation>
    </message>
    <message>
        <source>%1 cannot be read; Compare lists why.</source>
        <translation>%1 lässt sich nicht lesen; der Vergleich nennt den Grund.</translation>
    </message>
    <message>
        <source>Runs of this project cannot be read.

%1</source>
        <translation>Läufe dieses Projekts lassen sich nicht lesen.

%1</translation>
    </message>
    <message>
        <source>%1 is not deleted: it is no longer the run that was listed. Open the project again.</source>
        <translation>%1 wird nicht gelöscht: Es ist nicht mehr der aufgelistete Lauf. Öffnen Sie das Projekt neu.</translation>
    </message>
    <message>
        <source>%1 is not deleted: it is being copied. Wait until that is done.</source>
        <translation>%1 wird nicht gelöscht: Es wird gerade kopiert. Warten Sie, bis das fertig ist.</translation>
    </message>
    <message>
        <source>%1 is not deleted: a run is writing it. Stop that run first.</source>
        <translation>%1 wird nicht gelöscht: Ein Lauf schreibt es gerade. Stoppen Sie zuerst diesen Lauf.</translation>
    </message>
</context>
<context>
    <name>hygroloom::Quantity</name>
    <message>
        <source>Allowed: %1 to %2.</source>
        <translation>Erlaubt: %1 bis %2.</translation>
    </message>
    <message>
        <source>“%1” does not begin with a number.</source>
        <translation>„%1“ beginnt nicht mit einer Zahl.</translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>„%1“ ist keine ganze Zahl.</translation>
    </message>
    <message>
        <source>This number has no unit; remove “%1”.</source>
        <translation>Diese Zahl hat keine Einheit; entfernen Sie „%1“.</translation>
    </message>
    <message>
        <source>“%1” is not a unit of this field. Use %2.</source>
        <translation>„%1“ ist keine Einheit dieses Felds. Nehmen Sie %2.</translation>
    </message>
    <message>
        <source>Ne %1</source>
        <translation>Ne %1</translation>
    </message>
</context>
<context>
    <name>hygroloom::QuantityEdit</name>
    <message>
        <source>%1 is out of range. %2</source>
        <translation>%1 liegt außerhalb des Bereichs. %2</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>auto %1</source>
        <translation>auto %1</translation>
    </message>
    <message>
        <source>Calculated: %1.</source>
        <translation>Berechnet: %1.</translation>
    </message>
    <message>
        <source>In full: %1.</source>
        <translation>Vollständig: %1.</translation>
    </message>
</context>
<context>
    <name>hygroloom::QueueButton</name>
    <message>
        <source>Show the runs that are on, waiting or paused; pause, stop or reorder them.</source>
        <translation>Zeigt die Läufe, die laufen, warten oder pausiert sind; pausiert, stoppt oder ordnet sie.</translation>
    </message>
</context>
<context>
    <name>hygroloom::QueueList</name>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pausiert</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Wird gestoppt</translation>
    </message>
    <message>
        <source>Waits for memory of the device</source>
        <translation>Wartet auf Speicher des Geräts</translation>
    </message>
    <message>
        <source>Waits until other runs are done</source>
        <translation>Wartet, bis andere Läufe fertig sind</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 of %2 runs, %3</source>
        <translation>%1 von %2 Läufen, %3</translation>
    </message>
    <message>
        <source>, %1 failed</source>
        <translation>, %1 gescheitert</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stoppen</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Stop the selected runs. What has ended is kept.</source>
        <translation>Die gewählten Läufe stoppen. Was fertig ist, bleibt.</translation>
    </message>
    <message>
        <source>Let the selected runs take their turn before those above.</source>
        <translation>Die gewählten Läufe vor denen darüber an die Reihe lassen.</translation>
    </message>
    <message>
        <source>Let those below take their turn first.</source>
        <translation>Die darunter zuerst an die Reihe lassen.</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>%1 on</source>
        <translation>%1 laufend</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 wartend</translation>
    </message>
    <message>
        <source>%1 paused</source>
        <translation>%1 pausiert</translation>
    </message>
    <message>
        <source>Runs: %1</source>
        <translation>Läufe: %1</translation>
    </message>
    <message>
        <source>No run is on or waiting.</source>
        <translation>Es läuft und wartet kein Lauf.</translation>
    </message>
    <message>
        <source>Queue of Runs</source>
        <translation>Warteschlange der Läufe</translation>
    </message>
    <message>
        <source>Pause the selected runs, or let them go on when it is their turn. Others may take theirs meanwhile.</source>
        <translation>Die gewählten Läufe anhalten, oder weiterlaufen lassen, wenn sie an der Reihe sind. Andere können inzwischen an die Reihe kommen.</translation>
    </message>
</context>
<context>
    <name>hygroloom::QueuedRun</name>
    <message>
        <source>This run takes about %1 of memory; %2 are free. %3</source>
        <translation>Dieser Lauf belegt etwa %1 Speicher; %2 sind frei. %3</translation>
    </message>
    <message>
        <source>Not enough memory for this run. %1</source>
        <translation>Der Speicher reicht für diesen Lauf nicht. %1</translation>
    </message>
</context>
<context>
    <name>hygroloom::RatesFile</name>
    <message>
        <source>with skin temperatures</source>
        <translation>mit Hauttemperaturen</translation>
    </message>
    <message>
        <source>without skin temperatures</source>
        <translation>ohne Hauttemperaturen</translation>
    </message>
    <message>
        <source>%1 rows from %2 to %3 s, %4. Zones: %5.</source>
        <translation>%1 Zeilen von %2 bis %3 s, %4. Zonen: %5.</translation>
    </message>
    <message>
        <source>Use the Table</source>
        <translation>Tabelle verwenden</translation>
    </message>
    <message>
        <source>Take the zones&apos; rates over time from a CSV with the columns time_s, zone, g_m2_h and, if you have them, skin_temperature_c.</source>
        <translation>Die Raten der Zonen über die Zeit aus einer CSV-Datei nehmen, mit den Spalten time_s, zone, g_m2_h und, wenn Sie sie haben, skin_temperature_c.</translation>
    </message>
    <message>
        <source>Leave the file, and let the wearer sweat as the table of activity says.</source>
        <translation>Die Datei weglassen und den Träger nach der Tabelle der Aktivität schwitzen lassen.</translation>
    </message>
    <message>
        <source>What the file of rates holds</source>
        <translation>Was die Datei der Raten enthält</translation>
    </message>
    <message>
        <source>Rates over Time</source>
        <translation>Raten über die Zeit</translation>
    </message>
    <message>
        <source>Tables of rates (*.csv)</source>
        <translation>Tabellen von Raten (*.csv)</translation>
    </message>
    <message>
        <source>choose rates over time</source>
        <translation>Raten über die Zeit wählen</translation>
    </message>
    <message>
        <source>leave rates over time</source>
        <translation>Raten über die Zeit weglassen</translation>
    </message>
    <message>
        <source>Another CSV File…</source>
        <translation>Andere CSV-Datei…</translation>
    </message>
    <message>
        <source>From a CSV File…</source>
        <translation>Aus einer CSV-Datei…</translation>
    </message>
</context>
<context>
    <name>hygroloom::RecentFiles</name>
    <message>
        <source>&amp;Clear List</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
</context>
<context>
    <name>hygroloom::Recovery</name>
    <message>
        <source>%1 cannot be locked. Check that the folder can be written to.</source>
        <translation>%1 lässt sich nicht sperren. Prüfen Sie, ob in den Ordner geschrieben werden kann.</translation>
    </message>
    <message>
        <source>Unsaved work cannot be kept for recovery: %1</source>
        <translation>Ungespeicherte Arbeit lässt sich nicht zur Wiederherstellung aufheben: %1</translation>
    </message>
</context>
<context>
    <name>hygroloom::ReplicateStore</name>
    <message>
        <source>The numbers of earlier replicates cannot be read: %1</source>
        <translation>Die Zahlen früherer Wiederholungen lassen sich nicht lesen: %1</translation>
    </message>
</context>
<context>
    <name>hygroloom::ResultsPanel</name>
    <message>
        <source>took %1 s</source>
        <translation>dauerte %1 s</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>1 knob set</source>
        <translation>1 Stellgröße gesetzt</translation>
    </message>
    <message>
        <source>%1 knobs set</source>
        <translation>%1 Stellgrößen gesetzt</translation>
    </message>
    <message>
        <source>on the CPU</source>
        <translation>auf der CPU</translation>
    </message>
    <message>
        <source>on a GPU</source>
        <translation>auf einer GPU</translation>
    </message>
    <message>
        <source>Fidelity: %1</source>
        <translation>Genauigkeit: %1</translation>
    </message>
    <message>
        <source>%1 set to %2 (%3 has %4)</source>
        <translation>%1 auf %2 gesetzt (%3 hat %4)</translation>
    </message>
    <message>
        <source>%1 switched on by the user</source>
        <translation>%1 vom Benutzer eingeschaltet</translation>
    </message>
    <message>
        <source>%1 switched off by the user</source>
        <translation>%1 vom Benutzer ausgeschaltet</translation>
    </message>
    <message>
        <source>Device: %1</source>
        <translation>Gerät: %1</translation>
    </message>
    <message>
        <source>Started: %1</source>
        <translation>Begonnen: %1</translation>
    </message>
    <message>
        <source>About the results</source>
        <translation>Über die Ergebnisse</translation>
    </message>
    <message>
        <source>How the results were computed</source>
        <translation>Wie die Ergebnisse berechnet wurden</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Copy the Results</source>
        <translation>Ergebnisse kopieren</translation>
    </message>
    <message>
        <source>top (grade)</source>
        <translation>oben (Note)</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>bottom (grade)</source>
        <translation>unten (Note)</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>No results yet.</source>
        <translation>Noch keine Ergebnisse.</translation>
    </message>
    <message>
        <source>Run the experiment to see its results here.</source>
        <translation>Starten Sie den Versuch, um hier seine Ergebnisse zu sehen.</translation>
    </message>
    <message>
        <source>%1. &lt;a href=&apos;plan&apos;&gt;What was modelled…&lt;/a&gt;</source>
        <translation>%1. &lt;a href=&apos;plan&apos;&gt;Was modelliert wurde…&lt;/a&gt;</translation>
    </message>
    <message>
        <source>Radius of the smallest circle around all wet crossings of the face: it reaches the outermost.</source>
        <translation>Radius des kleinsten Kreises um alle nassen Kreuzungspunkte der Seite: Er reicht bis zum äußersten.</translation>
    </message>
    <message>
        <source>Half length of the filled ellipse that spreads as widely as the wet crossings on top (equal second moments). Single fingers count little in it.</source>
        <translation>Halbe Länge der gefüllten Ellipse, die so weit streut wie die nassen Kreuzungspunkte oben (gleiche zweite Momente). Einzelne Ausläufer zählen darin wenig.</translation>
    </message>
    <message>
        <source>Runs that are kept</source>
        <translation>Aufbewahrte Läufe</translation>
    </message>
    <message>
        <source>1 run is kept. &lt;a href=&apos;newest&apos;&gt;Open it&lt;/a&gt;, or run the experiment.</source>
        <translation>1 Lauf ist aufbewahrt. &lt;a href=&apos;newest&apos;&gt;Öffnen Sie ihn&lt;/a&gt;, oder starten Sie den Versuch.</translation>
    </message>
    <message>
        <source>%1 runs are kept. &lt;a href=&apos;newest&apos;&gt;Open the newest&lt;/a&gt;, choose one in Compare under All Runs, or run the experiment.</source>
        <translation>%1 Läufe sind aufbewahrt. &lt;a href=&apos;newest&apos;&gt;Öffnen Sie den neuesten&lt;/a&gt;, wählen Sie einen unter Vergleichen, Alle Läufe, oder starten Sie den Versuch.</translation>
    </message>
    <message>
        <source>A run of the selected fabric and experiment is kept. &lt;a href=&apos;chosen&apos;&gt;Open it&lt;/a&gt;.</source>
        <translation>Ein Lauf des gewählten Stoffs und Versuchs ist aufbewahrt. &lt;a href=&apos;chosen&apos;&gt;Öffnen&lt;/a&gt;.</translation>
    </message>
    <message>
        <source>The recording is being read: these are the numbers so far.</source>
        <translation>Die Aufzeichnung wird gelesen: bisherige Zahlen.</translation>
    </message>
    <message>
        <source>largest wetted radius</source>
        <translation>größter Benetzungsradius</translation>
    </message>
</context>
<context>
    <name>hygroloom::RunActions</name>
    <message>
        <source>&amp;Keep</source>
        <translation>Beha&amp;lten</translation>
    </message>
    <message>
        <source>For&amp;get…</source>
        <translation>V&amp;ergessen…</translation>
    </message>
    <message>
        <source>Forget &amp;Older…</source>
        <translation>&amp;Ältere vergessen…</translation>
    </message>
    <message>
        <source>Mark the selected run: Forget Older leaves it.</source>
        <translation>Markiert den gewählten Lauf: Ältere vergessen lässt ihn stehen.</translation>
    </message>
    <message>
        <source>Delete the selected run&apos;s recording, after a question. A recording that was opened only leaves the list.</source>
        <translation>Löscht nach einer Rückfrage die Aufzeichnung des gewählten Laufs. Eine nur geöffnete Aufzeichnung verlässt bloß die Liste.</translation>
    </message>
    <message>
        <source>Delete the runs of older designs that are not marked with Keep, after a question.</source>
        <translation>Löscht nach einer Rückfrage die Läufe älterer Entwürfe, die nicht mit Behalten markiert sind.</translation>
    </message>
    <message>
        <source>Size of the project&apos;s runs</source>
        <translation>Größe der Läufe des Projekts</translation>
    </message>
    <message>
        <source>1 run, %1</source>
        <translation>1 Lauf, %1</translation>
    </message>
    <message>
        <source>%1 runs, %2</source>
        <translation>%1 Läufe, %2</translation>
    </message>
    <message>
        <source>Forget this run?</source>
        <translation>Diesen Lauf vergessen?</translation>
    </message>
    <message>
        <source>Forget these %1 runs, %2?</source>
        <translation>Diese %1 Läufe, %2, vergessen?</translation>
    </message>
    <message>
        <source>Forget runs</source>
        <translation>Läufe vergessen</translation>
    </message>
    <message>
        <source>Its recording is deleted.</source>
        <translation>Seine Aufzeichnung wird gelöscht.</translation>
    </message>
    <message>
        <source>Their recordings are deleted.</source>
        <translation>Ihre Aufzeichnungen werden gelöscht.</translation>
    </message>
    <message>
        <source>&amp;Forget</source>
        <translation>&amp;Vergessen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>hygroloom::RunFilm</name>
    <message>
        <source>Saving pictures of the run</source>
        <translation>Bilder des Laufs werden gespeichert</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>Saving pictures</source>
        <translation>Bilder werden gespeichert</translation>
    </message>
    <message>
        <source>Cancelled after %1 of %2 pictures.</source>
        <translation>Nach %1 von %2 Bildern abgebrochen.</translation>
    </message>
    <message>
        <source>Cancelled after %1 pictures.</source>
        <translation>Nach %1 Bildern abgebrochen.</translation>
    </message>
</context>
<context>
    <name>hygroloom::RunHistory</name>
    <message>
        <source>The recording %1 holds another run now. Open it again to compare that run.</source>
        <translation>Die Aufzeichnung %1 enthält jetzt einen anderen Lauf. Öffnen Sie sie neu, um diesen Lauf zu vergleichen.</translation>
    </message>
    <message>
        <source>%1: %2, %3, %4</source>
        <translation>%1: %2, %3, %4</translation>
    </message>
    <message>
        <source>Only completed runs can be compared.</source>
        <translation>Nur vollständige Läufe lassen sich vergleichen.</translation>
    </message>
    <message>
        <source>The frames of this run are being read.</source>
        <translation>Die Bilder dieses Laufs werden gelesen.</translation>
    </message>
    <message>
        <source>This run is of another experiment. Only runs of the same experiment can be compared.</source>
        <translation>Dieser Lauf gehört zu einem anderen Versuch. Nur Läufe desselben Versuchs lassen sich vergleichen.</translation>
    </message>
    <message>
        <source>experiment is gone</source>
        <translation>Versuch fehlt</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>liquid</source>
        <translation>Flüssigkeit</translation>
    </message>
    <message>
        <source>fabric is gone</source>
        <translation>Gewebe fehlt</translation>
    </message>
    <message>
        <source>fabric</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>fibres</source>
        <translation>Fasern</translation>
    </message>
    <message>
        <source>garment is gone</source>
        <translation>Kleidungsstück fehlt</translation>
    </message>
    <message>
        <source>garment</source>
        <translation>Kleidungsstück</translation>
    </message>
    <message>
        <source>program</source>
        <translation>Programm</translation>
    </message>
</context>
<context>
    <name>hygroloom::RunList</name>
    <message>
        <source>kept</source>
        <translation>behalten</translation>
    </message>
    <message>
        <source>older design</source>
        <translation>älterer Entwurf</translation>
    </message>
    <message>
        <source>other design</source>
        <translation>anderer Entwurf</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>nicht gespeichert</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Runs to compare</source>
        <translation>Läufe zum Vergleichen</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Fidelity</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Took</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Double-click a run, or press Enter, to show it.</source>
        <translation>Ein Doppelklick auf einen Lauf oder die Eingabetaste zeigt ihn.</translation>
    </message>
    <message>
        <source>Tick two to four runs of the same experiment. Double-click one to open it.</source>
        <translation>Kreuzen Sie zwei bis vier Läufe desselben Versuchs an. Ein Doppelklick öffnet einen.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 aus %2</translation>
    </message>
    <message>
        <source>Runs of the project</source>
        <translation>Läufe des Projekts</translation>
    </message>
    <message>
        <source>Fabric or garment</source>
        <translation>Gewebe oder Kleidung</translation>
    </message>
    <message>
        <source>older program</source>
        <translation>älteres Programm</translation>
    </message>
</context>
<context>
    <name>hygroloom::RunPanel</name>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>What will be modelled, and why…</source>
        <translation>Was modelliert wird, und warum…</translation>
    </message>
    <message>
        <source>Starting.</source>
        <translation>Wird gestartet.</translation>
    </message>
    <message>
        <source>Paused.</source>
        <translation>Pausiert.</translation>
    </message>
    <message>
        <source>Resuming.</source>
        <translation>Wird fortgesetzt.</translation>
    </message>
    <message>
        <source>Fidelity: %1</source>
        <translation>Genauigkeit: %1</translation>
    </message>
    <message>
        <source>Expected for %1</source>
        <translation>Zu erwarten für %1</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Processor that runs the simulation.</source>
        <translation>Prozessor, der die Simulation rechnet.</translation>
    </message>
    <message>
        <source>Which physics the next run models, and the reasons.</source>
        <translation>Welche Physik der nächste Lauf modelliert, und die Gründe.</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>Fortschritt des Laufs</translation>
    </message>
    <message>
        <source>State of the run</source>
        <translation>Zustand des Laufs</translation>
    </message>
    <message>
        <source>Run the experiment on what is chosen (Ctrl+R).</source>
        <translation>Den Versuch mit dem Gewählten rechnen (Strg+R).</translation>
    </message>
    <message>
        <source>Resume the run.</source>
        <translation>Den Lauf fortsetzen.</translation>
    </message>
    <message>
        <source>Pause the run; its frames so far can be looked at.</source>
        <translation>Den Lauf pausieren; seine bisherigen Bilder lassen sich ansehen.</translation>
    </message>
    <message>
        <source>Cannot run: %1</source>
        <translation>Lässt sich nicht rechnen: %1</translation>
    </message>
    <message>
        <source>%1 particles of free liquid.</source>
        <translation>%1 Partikel freier Flüssigkeit.</translation>
    </message>
    <message>
        <source>Finished.</source>
        <translation>Fertig.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Gestoppt.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>hygroloom::RunWorkspace</name>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Garment</source>
        <translation>Kleidungsstück</translation>
    </message>
    <message>
        <source>Gaps and Seams</source>
        <translation>Abstände und Nähte</translation>
    </message>
    <message>
        <source>Subject</source>
        <translation>Gegenstand</translation>
    </message>
    <message>
        <source>What the experiment is run on: a sample of a fabric, or a garment.</source>
        <translation>Womit der Versuch gerechnet wird: eine Probe eines Gewebes oder ein Kleidungsstück.</translation>
    </message>
    <message>
        <source>Copying runs to the project: %1 %</source>
        <translation>Läufe werden zum Projekt kopiert: %1 %</translation>
    </message>
    <message>
        <source>Sample of %1</source>
        <translation>Probe von %1</translation>
    </message>
    <message>
        <source>Garment: %1</source>
        <translation>Kleidungsstück: %1</translation>
    </message>
    <message>
        <source>A garment, yet to be added</source>
        <translation>Ein Kleidungsstück, noch hinzuzufügen</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Pause or resume the run.</source>
        <translation>Den Lauf pausieren oder fortsetzen.</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>S&amp;topp</translation>
    </message>
    <message>
        <source>Stop the run, and say whether to keep what it recorded.</source>
        <translation>Den Lauf stoppen und sagen, ob das Aufgezeichnete bleibt.</translation>
    </message>
    <message>
        <source>&amp;What Will Be Modelled, and Why…</source>
        <translation>&amp;Was modelliert wird, und warum…</translation>
    </message>
    <message>
        <source>Which physics the next run models, and the reasons.</source>
        <translation>Welche Physik der nächste Lauf modelliert, und die Gründe.</translation>
    </message>
    <message>
        <source>&amp;Calibrate…</source>
        <translation>&amp;Kalibrieren…</translation>
    </message>
    <message>
        <source>Fit what is not known of the selected fabric to a measurement.</source>
        <translation>Was vom gewählten Gewebe nicht bekannt ist, an eine Messung anpassen.</translation>
    </message>
    <message>
        <source>P&amp;lay or Pause the Recording</source>
        <translation>Aufzeichnung a&amp;bspielen oder anhalten</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Play back the run.</source>
        <translation>Den Lauf abspielen.</translation>
    </message>
    <message>
        <source>Open the &amp;Design of the Recording</source>
        <translation>&amp;Entwurf der Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Edit the design from which the run on screen was made.</source>
        <translation>Den Entwurf bearbeiten, aus dem der gezeigte Lauf entstand.</translation>
    </message>
    <message>
        <source>Run the experiment on the chosen sample or garment.</source>
        <translation>Den Versuch mit der gewählten Probe oder dem gewählten Kleidungsstück rechnen.</translation>
    </message>
    <message>
        <source>&amp;Resume</source>
        <translation>&amp;Fortsetzen</translation>
    </message>
    <message>
        <source>The device failed</source>
        <translation>Das Gerät ist ausgefallen</translation>
    </message>
    <message>
        <source>%1

Run on the CPU instead?</source>
        <translation>%1

Stattdessen auf der CPU rechnen?</translation>
    </message>
    <message>
        <source>&amp;Run on the CPU</source>
        <translation>Auf der &amp;CPU rechnen</translation>
    </message>
    <message>
        <source>&amp;Do Not Run</source>
        <translation>&amp;Nicht rechnen</translation>
    </message>
    <message>
        <source>the experiment</source>
        <translation>der Versuch</translation>
    </message>
    <message>
        <source>A run is in progress</source>
        <translation>Ein Lauf ist im Gang</translation>
    </message>
    <message>
        <source>Stop the run of “%1”?</source>
        <translation>Den Lauf von „%1“ stoppen?</translation>
    </message>
    <message>
        <source>What is recorded up to now is kept with the project&apos;s runs.</source>
        <translation>Was bis jetzt aufgezeichnet ist, bleibt bei den Läufen des Projekts.</translation>
    </message>
    <message>
        <source>&amp;Stop and Keep What Is Recorded</source>
        <translation>&amp;Stoppen und Aufgezeichnetes behalten</translation>
    </message>
    <message>
        <source>&amp;Let It Run</source>
        <translation>&amp;Weiterlaufen lassen</translation>
    </message>
    <message>
        <source>Save Re&amp;cording As…</source>
        <translation>Aufzei&amp;chnung speichern unter…</translation>
    </message>
    <message>
        <source>Save the run that is shown.</source>
        <translation>Den gezeigten Lauf speichern.</translation>
    </message>
    <message>
        <source>Save Repor&amp;t…</source>
        <translation>Be&amp;richt speichern…</translation>
    </message>
    <message>
        <source>Save the results of the run that is shown, with maps and charts, as PDF or web page.</source>
        <translation>Die Ergebnisse des gezeigten Laufs mit Karten und Diagrammen als PDF oder Webseite speichern.</translation>
    </message>
    <message>
        <source>Design of %1</source>
        <translation>Entwurf von %1</translation>
    </message>
    <message>
        <source>Another recording is still being saved. Save this one when that is done.</source>
        <translation>Eine andere Aufzeichnung wird noch gespeichert. Speichern Sie diese, wenn jene fertig ist.</translation>
    </message>
    <message>
        <source>Save Recording</source>
        <translation>Aufzeichnung speichern</translation>
    </message>
    <message>
        <source>Recordings (*.hygrorec)</source>
        <translation>Aufzeichnungen (*.hygrorec)</translation>
    </message>
    <message>
        <source>Saving %1: %2 %</source>
        <translation>%1 wird gespeichert: %2 %</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>The recording cannot be written to %1: %2</source>
        <translation>Die Aufzeichnung lässt sich nicht in %1 schreiben: %2</translation>
    </message>
    <message>
        <source>%1 is saved. Files of its garment could not be copied beside it: %2. Its design needs them there.</source>
        <translation>%1 ist gespeichert. Dateien des Kleidungsstücks konnten nicht daneben kopiert werden: %2. Der Entwurf braucht sie dort.</translation>
    </message>
</context>
<context>
    <name>hygroloom::SampleSubject</name>
    <message>
        <source>Add a fabric to run an experiment on.</source>
        <translation>Fügen Sie ein Gewebe hinzu, mit dem der Versuch läuft.</translation>
    </message>
    <message>
        <source>Add an experiment to run.</source>
        <translation>Fügen Sie einen Versuch hinzu.</translation>
    </message>
    <message>
        <source>Choose a smaller sample or a lower fidelity.</source>
        <translation>Wählen Sie eine kleinere Probe oder eine geringere Genauigkeit.</translation>
    </message>
    <message>
        <source>Save Map of the Top &amp;Face…</source>
        <translation>&amp;Karte der Oberseite speichern…</translation>
    </message>
    <message>
        <source>Save the map of the top face at the time shown, as picture or table.</source>
        <translation>Die Karte der Oberseite zur gezeigten Zeit speichern, als Bild oder Tabelle.</translation>
    </message>
    <message>
        <source>Save Map of the &amp;Bottom Face…</source>
        <translation>Karte &amp;der Unterseite speichern…</translation>
    </message>
    <message>
        <source>Save the map of the bottom face at the time shown, as picture or table.</source>
        <translation>Die Karte der Unterseite zur gezeigten Zeit speichern, als Bild oder Tabelle.</translation>
    </message>
    <message>
        <source>Save Picture Se&amp;quence…</source>
        <translation>Bildfol&amp;ge speichern…</translation>
    </message>
    <message>
        <source>Save the picture at each time of the run that is shown, as numbered PNG files.</source>
        <translation>Das Bild zu jeder Zeit des gezeigten Laufs als nummerierte PNG-Dateien speichern.</translation>
    </message>
    <message>
        <source>Save Fil&amp;m (MP4)…</source>
        <translation>Fil&amp;m speichern (MP4)…</translation>
    </message>
    <message>
        <source>Save the pictures of the run that is shown as a film.</source>
        <translation>Die Bilder des gezeigten Laufs als Film speichern.</translation>
    </message>
    <message>
        <source>What W&amp;as Modelled, and Why…</source>
        <translation>W&amp;as modelliert wurde, und warum…</translation>
    </message>
    <message>
        <source>Which physics the run on screen modelled, and the reasons.</source>
        <translation>Welche Physik der gezeigte Lauf modelliert hat, und die Gründe.</translation>
    </message>
    <message>
        <source>&amp;Add Droplet</source>
        <translation>Tropfen &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Add a droplet to the experiment.</source>
        <translation>Dem Versuch einen Tropfen hinzufügen.</translation>
    </message>
    <message>
        <source>Add &amp;Experiment</source>
        <translation>&amp;Versuch hinzufügen</translation>
    </message>
    <message>
        <source>Add a copy of the experiment.</source>
        <translation>Eine Kopie des Versuchs hinzufügen.</translation>
    </message>
    <message>
        <source>Save Fil&amp;m (MP4): ffmpeg Is Not Installed</source>
        <translation>Fil&amp;m speichern (MP4): ffmpeg ist nicht installiert</translation>
    </message>
    <message>
        <source>These results are for “%1, %2”. Results has a link to the run of what is selected.</source>
        <translation>Diese Ergebnisse gehören zu „%1, %2“. Unter Ergebnisse steht ein Link zum Lauf des Gewählten.</translation>
    </message>
    <message>
        <source>These results are for “%1”. Run the selected fabric.</source>
        <translation>Diese Ergebnisse gehören zu „%1“. Rechnen Sie das gewählte Gewebe.</translation>
    </message>
    <message>
        <source>These results are for “%1”. Run the selected experiment.</source>
        <translation>Diese Ergebnisse gehören zu „%1“. Rechnen Sie den gewählten Versuch.</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Save Map of the Top Face</source>
        <translation>Karte der Oberseite speichern</translation>
    </message>
    <message>
        <source>Save Map of the Bottom Face</source>
        <translation>Karte der Unterseite speichern</translation>
    </message>
    <message>
        <source>%1, top</source>
        <translation>%1, oben</translation>
    </message>
    <message>
        <source>%1, bottom</source>
        <translation>%1, unten</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Table of the cells</source>
        <translation>Tabelle der Zellen</translation>
    </message>
    <message>
        <source>Folder for the Pictures</source>
        <translation>Ordner für die Bilder</translation>
    </message>
    <message>
        <source>The folder has pictures of a run</source>
        <translation>Der Ordner enthält Bilder eines Laufs</translation>
    </message>
    <message>
        <source>Write the pictures of this run over those in %1?</source>
        <translation>Die Bilder dieses Laufs über die in %1 schreiben?</translation>
    </message>
    <message>
        <source>%1 pictures with such names are there.</source>
        <translation>%1 Bilder mit solchen Namen sind da.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>Save Film</source>
        <translation>Film speichern</translation>
    </message>
    <message>
        <source>Films (*.mp4)</source>
        <translation>Filme (*.mp4)</translation>
    </message>
    <message>
        <source>about 4 min, 38 MB, error ≈ 14 %</source>
        <translation>etwa 4 min, 38 MB, Fehler ≈ 14 %</translation>
    </message>
    <message>
        <source>Out of date: the design or the program has changed since this run. Results has a link to a run of it.</source>
        <translation>Veraltet: Der Entwurf oder das Programm hat sich seit diesem Lauf geändert. Unter Ergebnisse steht ein Link zu einem passenden Lauf.</translation>
    </message>
    <message>
        <source>Out of date: the design or the program has changed since this run. Run again.</source>
        <translation>Veraltet: Der Entwurf oder das Programm hat sich seit diesem Lauf geändert. Rechnen Sie neu.</translation>
    </message>
</context>
<context>
    <name>hygroloom::ScatterView</name>
    <message>
        <source>smaller is better</source>
        <translation>kleiner ist besser</translation>
    </message>
    <message>
        <source>larger is better</source>
        <translation>größer ist besser</translation>
    </message>
    <message>
        <source>What the scatter shows</source>
        <translation>Was das Streudiagramm zeigt</translation>
    </message>
    <message>
        <source>Two numbers of all candidates</source>
        <translation>Zwei Zahlen aller Kandidaten</translation>
    </message>
    <message>
        <source>Number across</source>
        <translation>Zahl waagerecht</translation>
    </message>
    <message>
        <source>Number upwards</source>
        <translation>Zahl senkrecht</translation>
    </message>
    <message>
        <source>Candidate under the pointer</source>
        <translation>Kandidat unter dem Zeiger</translation>
    </message>
    <message>
        <source>Across:</source>
        <translation>Waagerecht:</translation>
    </message>
    <message>
        <source>Upwards:</source>
        <translation>Senkrecht:</translation>
    </message>
    <message>
        <source>There is nothing to draw yet: run the experiment on the fabrics.</source>
        <translation>Noch gibt es nichts zu zeichnen: Rechnen Sie den Versuch mit den Geweben.</translation>
    </message>
    <message>
        <source>Bars: the intervals of the table. Filled and connected: no other candidate is better in both numbers, by their middles (across: %1; upwards: %2).</source>
        <translation>Balken: die Intervalle der Tabelle. Gefüllt und verbunden: Kein anderer Kandidat ist nach den Mitten in beiden Zahlen besser (waagerecht: %1; senkrecht: %2).</translation>
    </message>
    <message>
        <source>shorter is better</source>
        <translation>kürzer ist besser</translation>
    </message>
    <message>
        <source>longer is better</source>
        <translation>länger ist besser</translation>
    </message>
    <message>
        <source>lower is better</source>
        <translation>niedriger ist besser</translation>
    </message>
    <message>
        <source>higher is better</source>
        <translation>höher ist besser</translation>
    </message>
</context>
<context>
    <name>hygroloom::ShapeView</name>
    <message>
        <source>The garment in 3D</source>
        <translation>Das Kleidungsstück in 3D</translation>
    </message>
    <message>
        <source>Drag to turn, middle button or Shift and drag to move, wheel to zoom, click to pin a place. Home shows the whole garment, 1, 3 and 7 look from the front, the side and the back.</source>
        <translation>Ziehen dreht, mittlere Taste oder Umschalt und Ziehen verschiebt, das Rad vergrößert, Klicken heftet einen Ort an. Pos1 zeigt das ganze Kleidungsstück, 1, 3 und 7 zeigen es von vorn, von der Seite und von hinten.</translation>
    </message>
    <message>
        <source>The picture needs OpenGL 3.3, which this display does not provide.</source>
        <translation>Das Bild braucht OpenGL 3.3, das diese Anzeige nicht bietet.</translation>
    </message>
</context>
<context>
    <name>hygroloom::StartPage</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>New project with a fabric of the library</source>
        <translation>Neues Projekt mit einem Stoff der Bibliothek</translation>
    </message>
    <message>
        <source>&amp;Show at start</source>
        <translation>Beim &amp;Start zeigen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>&amp;New Project</source>
        <translation>&amp;Neues Projekt</translation>
    </message>
    <message>
        <source>Start with a plain-weave fabric and one droplet.</source>
        <translation>Mit einem leinwandbindigen Stoff und einem Tropfen beginnen.</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a project or a recording.</source>
        <translation>Ein Projekt oder eine Aufzeichnung öffnen.</translation>
    </message>
    <message>
        <source>User&apos;s &amp;Guide</source>
        <translation>Hand&amp;buch</translation>
    </message>
    <message>
        <source>How to design a fabric and to run an experiment.</source>
        <translation>Wie man einen Stoff entwirft und einen Versuch rechnet.</translation>
    </message>
</context>
<context>
    <name>hygroloom::StepLegend</name>
    <message>
        <source>Legend of the colours</source>
        <translation>Legende der Farben</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 und mehr</translation>
    </message>
    <message>
        <source>%1 and less</source>
        <translation>%1 und weniger</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Difference B − A, g/m²</source>
        <translation>Differenz B − A, g/m²</translation>
    </message>
    <message>
        <source>−1000.5 and more</source>
        <translation>−1000.5 und mehr</translation>
    </message>
</context>
<context>
    <name>hygroloom::StepsDialog</name>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Steps of the Colours</source>
        <translation>Farbstufen</translation>
    </message>
    <message>
        <source>Why the ends are not in use</source>
        <translation>Warum die Enden nicht gelten</translation>
    </message>
    <message>
        <source>Even steps again, up to the end of the scale.</source>
        <translation>Wieder gleiche Stufen, bis zum Ende der Skala.</translation>
    </message>
    <message>
        <source>End of step %1</source>
        <translation>Ende der Stufe %1</translation>
    </message>
    <message>
        <source>Step %1 ends at</source>
        <translation>Stufe %1 endet bei</translation>
    </message>
    <message>
        <source>Step 1 must end above 0.</source>
        <translation>Stufe 1 muss über 0 enden.</translation>
    </message>
    <message>
        <source>Step %1 ends at %2; it must end above %3, where step %4 ends.</source>
        <translation>Stufe %1 endet bei %2; sie muss über %3 enden, wo Stufe %4 endet.</translation>
    </message>
</context>
<context>
    <name>hygroloom::StudyChart</name>
    <message>
        <source>Run a study, or open the results of one.</source>
        <translation>Rechnen Sie eine Studie oder öffnen Sie die Ergebnisse einer Studie.</translation>
    </message>
</context>
<context>
    <name>hygroloom::StudyPage</name>
    <message>
        <source>&amp;Run</source>
        <translation>Sta&amp;rten</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>S&amp;topp</translation>
    </message>
    <message>
        <source>Run the &amp;Failed Again</source>
        <translation>&amp;Misslungene erneut rechnen</translation>
    </message>
    <message>
        <source>For a C&amp;luster…</source>
        <translation>Für einen C&amp;luster…</translation>
    </message>
    <message>
        <source>&amp;Why They Failed…</source>
        <translation>Warum s&amp;ie misslangen…</translation>
    </message>
    <message>
        <source>&amp;Make Candidate</source>
        <translation>Kandidat daraus ma&amp;chen</translation>
    </message>
    <message>
        <source>What is wrong with the study</source>
        <translation>Was an der Studie nicht stimmt</translation>
    </message>
    <message>
        <source>What the study will cost</source>
        <translation>Was die Studie kosten wird</translation>
    </message>
    <message>
        <source>State of the study</source>
        <translation>Zustand der Studie</translation>
    </message>
    <message>
        <source>Unsaved study</source>
        <translation>Ungespeicherte Studie</translation>
    </message>
    <message>
        <source>%1 (edited)</source>
        <translation>%1 (geändert)</translation>
    </message>
    <message>
        <source>and %1 more.</source>
        <translation>und %1 weitere.</translation>
    </message>
    <message>
        <source>The cost is being worked out.</source>
        <translation>Der Aufwand wird ermittelt.</translation>
    </message>
    <message>
        <source>Open Study</source>
        <translation>Studie öffnen</translation>
    </message>
    <message>
        <source>Studies (*.json);;All files (*)</source>
        <translation>Studien (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Save Study</source>
        <translation>Studie speichern</translation>
    </message>
    <message>
        <source>Studies (*.json)</source>
        <translation>Studien (*.json)</translation>
    </message>
    <message>
        <source>The study is not saved</source>
        <translation>Die Studie ist nicht gespeichert</translation>
    </message>
    <message>
        <source>Save the changes to the study?</source>
        <translation>Die Änderungen an der Studie speichern?</translation>
    </message>
    <message>
        <source>Otherwise they are lost.</source>
        <translation>Sonst gehen sie verloren.</translation>
    </message>
    <message>
        <source>A study is in progress</source>
        <translation>Eine Studie ist im Gang</translation>
    </message>
    <message>
        <source>Stop the study?</source>
        <translation>Die Studie stoppen?</translation>
    </message>
    <message>
        <source>%1. Those are kept in its folder.</source>
        <translation>%1. Diese bleiben in ihrem Ordner.</translation>
    </message>
    <message>
        <source>Stop the Study</source>
        <translation>Studie stoppen</translation>
    </message>
    <message>
        <source>Folder for the Results</source>
        <translation>Ordner für die Ergebnisse</translation>
    </message>
    <message>
        <source>Open the Folder of a Study</source>
        <translation>Ordner einer Studie öffnen</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Begin another study.</source>
        <translation>Eine andere Studie beginnen.</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a study file.</source>
        <translation>Eine Studiendatei öffnen.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the study file.</source>
        <translation>Die Studiendatei speichern.</translation>
    </message>
    <message>
        <source>Sa&amp;ve As…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save the study file under another name.</source>
        <translation>Die Studiendatei unter einem anderen Namen speichern.</translation>
    </message>
    <message>
        <source>Name of the study</source>
        <translation>Name der Studie</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder for the results.</source>
        <translation>Den Ordner für die Ergebnisse wählen.</translation>
    </message>
    <message>
        <source>Folder for the results</source>
        <translation>Ordner für die Ergebnisse</translation>
    </message>
    <message>
        <source>Results in:</source>
        <translation>Ergebnisse in:</translation>
    </message>
    <message>
        <source>Run what the folder lacks of the study.</source>
        <translation>Rechnet, was dem Ordner von der Studie fehlt.</translation>
    </message>
    <message>
        <source>Stop. The runs that have ended are kept; Run goes on.</source>
        <translation>Stoppen. Die beendeten Läufe bleiben; Starten macht weiter.</translation>
    </message>
    <message>
        <source>Write the study for a cluster, and see what to type there.</source>
        <translation>Die Studie für einen Cluster schreiben und sehen, was dort einzugeben ist.</translation>
    </message>
    <message>
        <source>Open &amp;Results…</source>
        <translation>&amp;Ergebnisse öffnen…</translation>
    </message>
    <message>
        <source>Open the folder of a study that has run.</source>
        <translation>Den Ordner einer gerechneten Studie öffnen.</translation>
    </message>
    <message>
        <source>Results shown</source>
        <translation>Gezeigte Ergebnisse</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Main Effects</source>
        <translation>Haupteffekte</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>Parallel Coordinates</source>
        <translation>Parallele Koordinaten</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Sensitivität</translation>
    </message>
    <message>
        <source>Chosen row</source>
        <translation>Gewählte Zeile</translation>
    </message>
    <message>
        <source>Add a fabric with the values of the chosen row to the project.</source>
        <translation>Dem Projekt ein Gewebe mit den Werten der gewählten Zeile hinzufügen.</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Fortschritt der Studie</translation>
    </message>
    <message>
        <source>Rows of the study</source>
        <translation>Zeilen der Studie</translation>
    </message>
    <message>
        <source>Stopping.</source>
        <translation>Wird gestoppt.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>The study could not run.</source>
        <translation>Die Studie konnte nicht laufen.</translation>
    </message>
    <message>
        <source>%1 of %2 runs done, %3 failed</source>
        <translation>%1 von %2 Läufen fertig, %3 misslungen</translation>
    </message>
    <message>
        <source>Stopped. %1. Run goes on with those that are missing.</source>
        <translation>Gestoppt. %1. Starten rechnet die fehlenden weiter.</translation>
    </message>
    <message>
        <source>%1: The memory does not suffice for these results.</source>
        <translation>%1: Der Speicher reicht für diese Ergebnisse nicht.</translation>
    </message>
    <message>
        <source>%1: %2 rows</source>
        <translation>%1: %2 Zeilen</translation>
    </message>
    <message>
        <source>%1: %2 of %3 rows</source>
        <translation>%1: %2 von %3 Zeilen</translation>
    </message>
    <message>
        <source>, %1 failed</source>
        <translation>, %1 misslungen</translation>
    </message>
    <message>
        <source>No results are open.</source>
        <translation>Es sind keine Ergebnisse geöffnet.</translation>
    </message>
    <message>
        <source>%1 of %2 rows are in the ranges.</source>
        <translation>%1 von %2 Zeilen liegen in den Bereichen.</translation>
    </message>
    <message>
        <source>The indices are being computed.</source>
        <translation>Die Indizes werden berechnet.</translation>
    </message>
    <message>
        <source>Point %1: %2</source>
        <translation>Punkt %1: %2</translation>
    </message>
    <message>
        <source>%1 more failed.</source>
        <translation>%1 weitere misslangen.</translation>
    </message>
    <message>
        <source>Runs that failed</source>
        <translation>Misslungene Läufe</translation>
    </message>
    <message>
        <source>1 run failed.</source>
        <translation>1 Lauf misslang.</translation>
    </message>
    <message>
        <source>%1 runs failed.</source>
        <translation>%1 Läufe misslangen.</translation>
    </message>
    <message>
        <source>&amp;Discard the Changes</source>
        <translation>Änderungen &amp;verwerfen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>hygroloom::StudyRuns</name>
    <message>
        <source>%1 of %2 runs done</source>
        <translation>%1 von %2 Läufen fertig</translation>
    </message>
    <message>
        <source>Compare: %1</source>
        <translation>Vergleich: %1</translation>
    </message>
    <message>
        <source>Choose a smaller sample or a lower fidelity.</source>
        <translation>Wählen Sie eine kleinere Probe oder eine geringere Genauigkeit.</translation>
    </message>
    <message>
        <source>%1, paused.</source>
        <translation>%1, pausiert.</translation>
    </message>
    <message>
        <source>%1, %2 left.</source>
        <translation>%1, noch %2.</translation>
    </message>
</context>
<context>
    <name>hygroloom::StudySetup</name>
    <message>
        <source>Fabrics of the study</source>
        <translation>Gewebe der Studie</translation>
    </message>
    <message>
        <source>Experiments of the study</source>
        <translation>Versuche der Studie</translation>
    </message>
    <message>
        <source>Metrics of the study</source>
        <translation>Kennzahlen der Studie</translation>
    </message>
    <message>
        <source>&amp;Add Factors…</source>
        <translation>Faktoren hin&amp;zufügen…</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>L&amp;öschen</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <source>Factors of the study</source>
        <translation>Faktoren der Studie</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>Faktoren</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Latin hypercube</source>
        <translation>Latin Hypercube</translation>
    </message>
    <message>
        <source>Sobol sequence</source>
        <translation>Sobol-Folge</translation>
    </message>
    <message>
        <source>One at a time</source>
        <translation>Einzeln</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Fastest within an error</source>
        <translation>Nach Fehlergrenze</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Points laid out for it</source>
        <translation>Eigene Punkte</translation>
    </message>
    <message>
        <source>From a surface</source>
        <translation>Aus einer Fläche</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Design:</source>
        <translation>Versuchsplan:</translation>
    </message>
    <message>
        <source>How the points are spread over the factors.</source>
        <translation>Wie die Punkte über die Faktoren verteilt sind.</translation>
    </message>
    <message>
        <source>Points:</source>
        <translation>Punkte:</translation>
    </message>
    <message>
        <source>Of a grid, the most that there may be.</source>
        <translation>Bei einem Gitter die größte erlaubte Zahl.</translation>
    </message>
    <message>
        <source>Replicates:</source>
        <translation>Wiederholungen:</translation>
    </message>
    <message>
        <source>Runs of each point with cloths that their description leaves open.</source>
        <translation>Läufe jedes Punkts mit Geweben, die ihre Beschreibung offen lässt.</translation>
    </message>
    <message>
        <source>Fidelity:</source>
        <translation>Genauigkeit:</translation>
    </message>
    <message>
        <source>Error at most:</source>
        <translation>Fehler höchstens:</translation>
    </message>
    <message>
        <source>Sensitivity:</source>
        <translation>Sensitivität:</translation>
    </message>
    <message>
        <source>Which factors matter. Points laid out for it need some hundred points a factor; a surface fitted to the points needs fewer.</source>
        <translation>Welche Faktoren wichtig sind. Dafür gelegte Punkte brauchen einige hundert je Faktor; eine an die Punkte angepasste Fläche braucht weniger.</translation>
    </message>
    <message>
        <source>Seed:</source>
        <translation>Startzahl:</translation>
    </message>
    <message>
        <source>The same seed gives the same points.</source>
        <translation>Dieselbe Startzahl gibt dieselben Punkte.</translation>
    </message>
    <message>
        <source>%1 (not in this project)</source>
        <translation>%1 (nicht in diesem Projekt)</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>unvollständig</translation>
    </message>
    <message>
        <source>Now %1.</source>
        <translation>Jetzt %1.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Seed: This must be a whole number from 0 to 18446744073709551615; given is “%1”.</source>
        <translation>Startzahl: Dies muss eine ganze Zahl von 0 bis 18446744073709551615 sein; eingegeben ist „%1“.</translation>
    </message>
    <message>
        <source>Fabrics: Tick one at least.</source>
        <translation>Gewebe: Kreuzen Sie mindestens eines an.</translation>
    </message>
    <message>
        <source>Experiments: Tick one at least.</source>
        <translation>Versuche: Kreuzen Sie mindestens einen an.</translation>
    </message>
    <message>
        <source>The project has an error; the Issues panel says which.</source>
        <translation>Das Projekt hat einen Fehler; das Feld Meldungen nennt ihn.</translation>
    </message>
    <message>
        <source>Each ticked fabric takes the place of all panels&apos; own. Tick none to leave the garment as it is cut.</source>
        <translation>Jedes angekreuzte Gewebe ersetzt die aller Schnittteile. Ohne ein angekreuztes bleibt das Kleidungsstück, wie es geschnitten ist.</translation>
    </message>
</context>
<context>
    <name>hygroloom::StudyTableModel</name>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>replicate</source>
        <translation>Wiederholung</translation>
    </message>
    <message>
        <source>status</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>time taken (s)</source>
        <translation>Dauer (s)</translation>
    </message>
    <message>
        <source>device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>why it failed</source>
        <translation>warum misslungen</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>misslungen</translation>
    </message>
</context>
<context>
    <name>hygroloom::StudyTask</name>
    <message>
        <source>The memory does not suffice for this study. Choose a lower fidelity, or fewer points.</source>
        <translation>Der Speicher reicht für diese Studie nicht. Wählen Sie eine geringere Genauigkeit oder weniger Punkte.</translation>
    </message>
    <message>
        <source>Preparing the runs.</source>
        <translation>Die Läufe werden vorbereitet.</translation>
    </message>
    <message>
        <source>%1 of %2 runs</source>
        <translation>%1 von %2 Läufen</translation>
    </message>
    <message>
        <source>, %1 failed</source>
        <translation>, %1 misslungen</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, noch %2</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>%1, paused</source>
        <translation>%1, pausiert</translation>
    </message>
</context>
<context>
    <name>hygroloom::TextileCanvas</name>
    <message>
        <source>Picture of the woven fabric</source>
        <translation>Bild des Gewebes</translation>
    </message>
    <message>
        <source>Drag to turn, middle button or Shift and drag to move, wheel to zoom, click to choose a yarn. Arrow keys turn, plus and minus zoom, square brackets go from yarn to yarn. F shows the whole fabric, 1, 3 and 7 look from the front, the right and the top.</source>
        <translation>Ziehen dreht, mittlere Taste oder Umschalt und Ziehen verschiebt, das Rad vergrößert, Klicken wählt einen Faden. Pfeiltasten drehen, Plus und Minus vergrößern und verkleinern, eckige Klammern gehen von Faden zu Faden. F zeigt das ganze Gewebe, 1, 3 und 7 zeigen es von vorn, von rechts und von oben.</translation>
    </message>
    <message>
        <source>weft %1 mm, warp %2 mm</source>
        <translation>Schuss %1 mm, Kette %2 mm</translation>
    </message>
    <message>
        <source>Click the first point on a yarn. Esc ends measuring.</source>
        <translation>Klicken Sie den ersten Punkt auf einem Faden an. Esc beendet das Messen.</translation>
    </message>
    <message>
        <source>Click the second point. Esc starts again.</source>
        <translation>Klicken Sie den zweiten Punkt an. Esc beginnt von vorn.</translation>
    </message>
    <message>
        <source>End %1 of the repeat, %2 of the piece</source>
        <translation>Kettfaden %1 des Rapports, %2 des Stücks</translation>
    </message>
    <message>
        <source>Pick %1 of the repeat, %2 of the piece</source>
        <translation>Schuss %1 des Rapports, %2 des Stücks</translation>
    </message>
    <message>
        <source>warp %1, weft %2, height %3</source>
        <translation>Kette %1, Schuss %2, Höhe %3</translation>
    </message>
    <message>
        <source>warp</source>
        <translation>Kette</translation>
    </message>
    <message>
        <source>weft</source>
        <translation>Schuss</translation>
    </message>
    <message>
        <source>End %1, pick %2: %3</source>
        <translation>Kettfaden %1, Schuss %2: %3</translation>
    </message>
    <message>
        <source>warp over weft</source>
        <translation>Kette über Schuss</translation>
    </message>
    <message>
        <source>weft over warp</source>
        <translation>Schuss über Kette</translation>
    </message>
</context>
<context>
    <name>hygroloom::TimeChartView</name>
    <message>
        <source>Click to show that time.</source>
        <translation>Klicken zeigt diese Zeit.</translation>
    </message>
</context>
<context>
    <name>hygroloom::Timeline</name>
    <message>
        <source>To the start</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>Abspielen oder anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Zum Ende</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>Gezeigte Zeit</translation>
    </message>
    <message>
        <source>What has happened</source>
        <translation>Was geschehen ist</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>hygroloom::ViewBar</name>
    <message>
        <source>View of the fabric</source>
        <translation>Ansicht des Gewebes</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>Ein&amp;passen</translation>
    </message>
    <message>
        <source>Show the whole fabric.</source>
        <translation>Das ganze Gewebe zeigen.</translation>
    </message>
    <message>
        <source>&amp;Look From</source>
        <translation>B&amp;lick von</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>Look along the warp.</source>
        <translation>In Kettrichtung blicken.</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>Look against the warp.</source>
        <translation>Gegen die Kettrichtung blicken.</translation>
    </message>
    <message>
        <source>Ri&amp;ght</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>Look along the weft.</source>
        <translation>In Schussrichtung blicken.</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>Look against the weft.</source>
        <translation>Gegen die Schussrichtung blicken.</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Look down on the fabric.</source>
        <translation>Von oben auf das Gewebe blicken.</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>Look up at the fabric.</source>
        <translation>Von unten auf das Gewebe blicken.</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isometrisch</translation>
    </message>
    <message>
        <source>Isometric view.</source>
        <translation>Isometrische Ansicht.</translation>
    </message>
    <message>
        <source>&amp;Few Repeats</source>
        <translation>Weni&amp;ge Rapporte</translation>
    </message>
    <message>
        <source>Show a few repeats in the middle.</source>
        <translation>Einige Rapporte in der Mitte zeigen.</translation>
    </message>
    <message>
        <source>&amp;Zoom to the Selected Yarn</source>
        <translation>Auf den gewählten Fa&amp;den</translation>
    </message>
    <message>
        <source>Show a few crossings of the selected yarn.</source>
        <translation>Einige Kreuzungspunkte des gewählten Fadens zeigen.</translation>
    </message>
    <message>
        <source>&amp;Next Yarn</source>
        <translation>&amp;Nächster Faden</translation>
    </message>
    <message>
        <source>Select the next yarn.</source>
        <translation>Den nächsten Faden wählen.</translation>
    </message>
    <message>
        <source>&amp;Previous Yarn</source>
        <translation>Vorh&amp;eriger Faden</translation>
    </message>
    <message>
        <source>Select the previous yarn.</source>
        <translation>Den vorherigen Faden wählen.</translation>
    </message>
    <message>
        <source>P&amp;arallel</source>
        <translation>Pa&amp;rallel</translation>
    </message>
    <message>
        <source>Parallel projection, without perspective.</source>
        <translation>Parallelprojektion, ohne Perspektive.</translation>
    </message>
    <message>
        <source>Pa&amp;rticles</source>
        <translation>Par&amp;tikel</translation>
    </message>
    <message>
        <source>Show the particles of free liquid instead of its surface.</source>
        <translation>Die Partikel der freien Flüssigkeit statt ihrer Oberfläche zeigen.</translation>
    </message>
    <message>
        <source>S&amp;watch</source>
        <translation>St&amp;offmuster</translation>
    </message>
    <message>
        <source>5 mm</source>
        <translation>5 mm</translation>
    </message>
    <message>
        <source>2 cm</source>
        <translation>2 cm</translation>
    </message>
    <message>
        <source>5 cm</source>
        <translation>5 cm</translation>
    </message>
    <message>
        <source>10 cm</source>
        <translation>10 cm</translation>
    </message>
    <message>
        <source>&amp;Mouse</source>
        <translation>&amp;Maus</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Viewing direction</source>
        <translation>Blickrichtung</translation>
    </message>
    <message>
        <source>Swatch</source>
        <translation>Stoffmuster</translation>
    </message>
    <message>
        <source>Size of the swatch on screen</source>
        <translation>Größe des Stoffmusters auf dem Bildschirm</translation>
    </message>
    <message>
        <source>S&amp;ection</source>
        <translation>Schn&amp;itt</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Keiner</translation>
    </message>
    <message>
        <source>Across the &amp;Warp</source>
        <translation>Quer zur K&amp;ette</translation>
    </message>
    <message>
        <source>Across the We&amp;ft</source>
        <translation>Quer zum &amp;Schuss</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>&amp;Waagerecht</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Cut the fabric open</source>
        <translation>Das Gewebe aufschneiden</translation>
    </message>
    <message>
        <source>Position of the cut</source>
        <translation>Lage des Schnitts</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Distance of the cut from the middle</source>
        <translation>Abstand des Schnitts von der Mitte</translation>
    </message>
    <message>
        <source>Other Half</source>
        <translation>Andere Hälfte</translation>
    </message>
    <message>
        <source>Keep the other half of the fabric.</source>
        <translation>Die andere Hälfte des Gewebes behalten.</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>Stre&amp;cke messen</translation>
    </message>
    <message>
        <source>Measure the distance between two points on yarns.</source>
        <translation>Den Abstand zweier Punkte auf Fäden messen.</translation>
    </message>
    <message>
        <source>yarn centrelines</source>
        <translation>Mittellinien der Garne</translation>
    </message>
    <message>
        <source>yarn surfaces</source>
        <translation>Oberflächen der Garne</translation>
    </message>
    <message>
        <source>Measure between</source>
        <translation>Messen zwischen</translation>
    </message>
    <message>
        <source>S&amp;hadow</source>
        <translation>Sc&amp;hatten</translation>
    </message>
    <message>
        <source>Show the shadow of the fabric on the ground.</source>
        <translation>Zeigt den Schatten des Gewebes auf dem Boden.</translation>
    </message>
</context>
<context>
    <name>hygroloom::Viewport</name>
    <message>
        <source>This display cannot draw the fabric.</source>
        <translation>Diese Anzeige kann das Gewebe nicht zeichnen.</translation>
    </message>
    <message>
        <source>%1, dry</source>
        <translation>%1, trocken</translation>
    </message>
    <message>
        <source>The recording does not contain its fabric “%1”.</source>
        <translation>Die Aufzeichnung enthält ihr Gewebe „%1“ nicht.</translation>
    </message>
    <message>
        <source>Pores filled</source>
        <translation>Gefüllte Poren</translation>
    </message>
    <message>
        <source>End %1, pick %2 of the pores filled</source>
        <translation>Kettfaden %1, Schuss %2 der Poren gefüllt</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>Feuchte</translation>
    </message>
    <message>
        <source>Relative humidity in the yarns: end %1, pick %2</source>
        <translation>Relative Feuchte in den Garnen: Kettfaden %1, Schuss %2</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>End %1, pick %2</source>
        <translation>Kettfaden %1, Schuss %2</translation>
    </message>
</context>
<context>
    <name>hygroloom::WaterMap</name>
    <message>
        <source>Most water %1 grams per square metre</source>
        <translation>Höchster Wert %1 Gramm Wasser je Quadratmeter</translation>
    </message>
    <message>
        <source>Largest difference to the baseline %1 grams per square metre; %2 of %3 cells differ.</source>
        <translation>Größter Unterschied zum Bezug %1 Gramm je Quadratmeter; %2 von %3 Zellen unterscheiden sich.</translation>
    </message>
    <message>
        <source>%1 g/m²</source>
        <translation>%1 g/m²</translation>
    </message>
    <message>
        <source>%1 g/m² less than the baseline</source>
        <translation>%1 g/m² weniger als der Bezug</translation>
    </message>
    <message>
        <source>%1 g/m² more than the baseline</source>
        <translation>%1 g/m² mehr als der Bezug</translation>
    </message>
    <message>
        <source>, not shown to differ</source>
        <translation>, kein Unterschied gezeigt</translation>
    </message>
    <message>
        <source>dry</source>
        <translation>trocken</translation>
    </message>
    <message>
        <source>5th to 95th percentile of %1 replicates</source>
        <translation>5. bis 95. Perzentil von %1 Wiederholungen</translation>
    </message>
    <message>
        <source>least to most of %1 replicates</source>
        <translation>kleinste bis größte von %1 Wiederholungen</translation>
    </message>
    <message>
        <source>%1; wetted radius now %2.</source>
        <translation>%1; benetzter Radius jetzt %2.</translation>
    </message>
    <message>
        <source>%1 (%2, in cells of %5 mm: %3 to %4)</source>
        <translation>%1 (%2, in Zellen von %5 mm: %3 bis %4)</translation>
    </message>
    <message>
        <source>wetted radius now %1</source>
        <translation>benetzter Radius jetzt %1</translation>
    </message>
    <message>
        <source>Temperatures from %1 to %2.</source>
        <translation>Temperaturen von %1 bis %2.</translation>
    </message>
    <message>
        <source>Humidities from %1 to %2.</source>
        <translation>Feuchten von %1 bis %2.</translation>
    </message>
    <message>
        <source>%1: %2 at %3, %4 %5</source>
        <translation>%1: %2 bei %3, %4 %5</translation>
    </message>
</context>
<context>
    <name>hygroloom::WaterMapView</name>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Map resolution, crossings per cell</source>
        <translation>Auflösung der Karten, Kreuzungspunkte je Zelle</translation>
    </message>
    <message>
        <source>Each cell of the maps is the mean over N × N crossings.</source>
        <translation>Jede Zelle der Karten ist das Mittel über N × N Kreuzungspunkte.</translation>
    </message>
    <message>
        <source>Value under the pointer</source>
        <translation>Wert unter dem Zeiger</translation>
    </message>
    <message>
        <source>Map resolution (crossings per cell)</source>
        <translation>Kartenauflösung (Kreuzungen je Zelle)</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>g/m²</source>
        <translation>g/m²</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>Feuchte</translation>
    </message>
    <message>
        <source>What the maps and the picture show</source>
        <translation>Was die Karten und das Bild zeigen</translation>
    </message>
    <message>
        <source>Temperature (not modelled)</source>
        <translation>Temperatur (nicht gerechnet)</translation>
    </message>
    <message>
        <source>Humidity (not modelled)</source>
        <translation>Feuchte (nicht gerechnet)</translation>
    </message>
    <message>
        <source>Relative humidity of the air in the yarns&apos; pores.</source>
        <translation>Relative Feuchte der Luft in den Poren der Garne.</translation>
    </message>
    <message>
        <source>Run the experiment, or open a run that is kept, to see how the water spreads on both faces.</source>
        <translation>Starten Sie den Versuch, oder öffnen Sie einen aufbewahrten Lauf, um zu sehen, wie sich das Wasser auf beiden Seiten ausbreitet.</translation>
    </message>
    <message>
        <source>No run is shown whose map could be saved.</source>
        <translation>Es ist kein Lauf zu sehen, dessen Karte gespeichert werden könnte.</translation>
    </message>
</context>
<context>
    <name>hygroloom::WearForm</name>
    <message>
        <source>Activity</source>
        <translation>Aktivität</translation>
    </message>
    <message>
        <source>Wear experiment</source>
        <translation>Trageversuch</translation>
    </message>
    <message>
        <source>Add an experiment on this garment</source>
        <translation>Einen Versuch mit diesem Kleidungsstück hinzufügen</translation>
    </message>
    <message>
        <source>Rename the experiment</source>
        <translation>Den Versuch umbenennen</translation>
    </message>
    <message>
        <source>Rename the Experiment</source>
        <translation>Versuch umbenennen</translation>
    </message>
    <message>
        <source>Remove the experiment</source>
        <translation>Den Versuch entfernen</translation>
    </message>
    <message>
        <source>change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Activity over time</source>
        <translation>Aktivität über die Zeit</translation>
    </message>
    <message>
        <source>Add a change of activity</source>
        <translation>Eine Änderung der Aktivität hinzufügen</translation>
    </message>
    <message>
        <source>Remove the selected change of activity</source>
        <translation>Die gewählte Änderung der Aktivität entfernen</translation>
    </message>
    <message>
        <source>add activity</source>
        <translation>Aktivität hinzufügen</translation>
    </message>
    <message>
        <source>remove activity</source>
        <translation>Aktivität entfernen</translation>
    </message>
    <message>
        <source>Activity: %1</source>
        <translation>Aktivität: %1</translation>
    </message>
    <message>
        <source>%1 says how the zones sweat over time.</source>
        <translation>%1 sagt, wie die Zonen über die Zeit schwitzen.</translation>
    </message>
    <message>
        <source>Time %1</source>
        <translation>Zeit %1</translation>
    </message>
    <message>
        <source>change time of activity</source>
        <translation>Zeit der Aktivität ändern</translation>
    </message>
    <message>
        <source>Factor %1</source>
        <translation>Faktor %1</translation>
    </message>
    <message>
        <source>change activity</source>
        <translation>Aktivität ändern</translation>
    </message>
    <message>
        <source>From this time on, sweat rates are those of the table of zones times this number: 1 gives the table&apos;s rates, 0 none. The table is chosen in Garment, under Sweat.</source>
        <translation>Ab dieser Zeit gelten die Raten der Zonentabelle mal dieser Zahl: 1 ergibt die Raten der Tabelle, 0 keinen Schweiß. Die Tabelle wird unter Kleidungsstück, Schweiß gewählt.</translation>
    </message>
    <message>
        <source>Sweat factor</source>
        <translation>Schweißfaktor</translation>
    </message>
</context>
<context>
    <name>hygroloom::WearPlayback</name>
    <message>
        <source>Share of capacity at the pin</source>
        <translation>Füllgrad am angehefteten Ort</translation>
    </message>
    <message>
        <source>Water at the pin</source>
        <translation>Wasser am angehefteten Ort</translation>
    </message>
    <message>
        <source>Share of the garment&apos;s capacity</source>
        <translation>Füllgrad des Kleidungsstücks</translation>
    </message>
    <message>
        <source>Water in the garment</source>
        <translation>Wasser im Kleidungsstück</translation>
    </message>
    <message>
        <source>g/m²</source>
        <translation>g/m²</translation>
    </message>
</context>
<context>
    <name>hygroloom::WeaveEditor</name>
    <message>
        <source>Ends of the repeat</source>
        <translation>Kettfäden des Rapports</translation>
    </message>
    <message>
        <source>Picks of the repeat</source>
        <translation>Schüsse des Rapports</translation>
    </message>
    <message>
        <source>Weave pattern</source>
        <translation>Bindungsmuster</translation>
    </message>
    <message>
        <source>Choose a weave, or type one such as “twill 3/1 S” or “satin 8/3”.</source>
        <translation>Wählen Sie eine Bindung oder geben Sie eine ein, etwa „twill 3/1 S“ oder „satin 8/3“.</translation>
    </message>
    <message>
        <source>free weave</source>
        <translation>freie Bindung</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Edit the draft</source>
        <translation>Webbrief bearbeiten</translation>
    </message>
    <message>
        <source>Edit threading, tie-up, treadling and the order of the yarns.</source>
        <translation>Einzug, Schnürung, Trittfolge und die Folge der Garne bearbeiten.</translation>
    </message>
    <message>
        <source>weave</source>
        <translation>Bindung</translation>
    </message>
    <message>
        <source>weave pattern</source>
        <translation>Bindungsmuster</translation>
    </message>
    <message>
        <source>size of the repeat</source>
        <translation>Größe des Rapports</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Zoom In</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom Out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Fit the Repeat</source>
        <translation>Rapport einpassen</translation>
    </message>
    <message>
        <source>Mirror Left and Right</source>
        <translation>Links und rechts spiegeln</translation>
    </message>
    <message>
        <source>mirrored ends</source>
        <translation>gespiegelte Kettfäden</translation>
    </message>
    <message>
        <source>Mirror Top and Bottom</source>
        <translation>Oben und unten spiegeln</translation>
    </message>
    <message>
        <source>mirrored picks</source>
        <translation>gespiegelte Schüsse</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>inverted weave</source>
        <translation>umgekehrte Bindung</translation>
    </message>
    <message>
        <source>Rotate by 90°</source>
        <translation>Um 90° drehen</translation>
    </message>
    <message>
        <source>rotated weave</source>
        <translation>gedrehte Bindung</translation>
    </message>
    <message>
        <source>shifted weave</source>
        <translation>verschobene Bindung</translation>
    </message>
    <message>
        <source>Shift Left</source>
        <translation>Nach links schieben</translation>
    </message>
    <message>
        <source>Shift Right</source>
        <translation>Nach rechts schieben</translation>
    </message>
    <message>
        <source>Shift Up</source>
        <translation>Nach oben schieben</translation>
    </message>
    <message>
        <source>Shift Down</source>
        <translation>Nach unten schieben</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>cut weave</source>
        <translation>ausgeschnittene Bindung</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>cleared weave</source>
        <translation>geleerte Bindung</translation>
    </message>
    <message>
        <source>Insert End</source>
        <translation>Kettfaden einfügen</translation>
    </message>
    <message>
        <source>inserted end</source>
        <translation>eingefügter Kettfaden</translation>
    </message>
    <message>
        <source>Insert Pick</source>
        <translation>Schuss einfügen</translation>
    </message>
    <message>
        <source>inserted pick</source>
        <translation>eingefügter Schuss</translation>
    </message>
    <message>
        <source>Delete End</source>
        <translation>Kettfaden löschen</translation>
    </message>
    <message>
        <source>deleted end</source>
        <translation>gelöschter Kettfaden</translation>
    </message>
    <message>
        <source>Delete Pick</source>
        <translation>Schuss löschen</translation>
    </message>
    <message>
        <source>deleted pick</source>
        <translation>gelöschter Schuss</translation>
    </message>
    <message>
        <source>The copied part of %1 × %2 crossings does not fit into the repeat of %3 × %4. Enlarge the repeat first.</source>
        <translation>Der kopierte Teil von %1 × %2 Kreuzungspunkten passt nicht in den Rapport von %3 × %4. Vergrößern Sie zuerst den Rapport.</translation>
    </message>
    <message>
        <source>pasted weave</source>
        <translation>eingefügte Bindung</translation>
    </message>
    <message>
        <source>The clipboard holds no text; copy rows of 0 and 1.</source>
        <translation>Die Zwischenablage enthält keinen Text; kopieren Sie Zeilen aus 0 und 1.</translation>
    </message>
    <message>
        <source>The rows on the clipboard differ in length; make them alike.</source>
        <translation>Die Zeilen in der Zwischenablage sind verschieden lang; machen Sie sie gleich.</translation>
    </message>
    <message>
        <source>The clipboard holds no weave; copy rows of 0 and 1.</source>
        <translation>Die Zwischenablage enthält keine Bindung; kopieren Sie Zeilen aus 0 und 1.</translation>
    </message>
    <message>
        <source>What is on the clipboard is larger than 2000 ends or picks.</source>
        <translation>Der Inhalt der Zwischenablage ist größer als 2000 Kettfäden oder Schüsse.</translation>
    </message>
</context>
<context>
    <name>hygroloom::WeaveNotes</name>
    <message>
        <source>Notes about the weave</source>
        <translation>Hinweise zur Bindung</translation>
    </message>
    <message>
        <source>About the weave</source>
        <translation>Über die Bindung</translation>
    </message>
    <message>
        <source>Warnings about the weave</source>
        <translation>Warnungen zur Bindung</translation>
    </message>
    <message>
        <source>Add a fabric to draw its weave.</source>
        <translation>Fügen Sie ein Gewebe hinzu, um seine Bindung zu zeichnen.</translation>
    </message>
    <message>
        <source>Longest floats: warp %1, weft %2. Warp shows on %3 % of the face.</source>
        <translation>Längste Flottierungen: Kette %1, Schuss %2. Auf der Oberseite liegt zu %3 % Kette.</translation>
    </message>
    <message>
        <source>%1 % of the crossings interlace.</source>
        <translation>%1 % der Kreuzungspunkte binden ab.</translation>
    </message>
    <message>
        <source>It repeats every %1 × %2.</source>
        <translation>Sie wiederholt sich alle %1 × %2.</translation>
    </message>
    <message>
        <source>A float passes over or under several yarns of the other system. 100 % interlacing is plain weave.</source>
        <translation>Eine Flottierung läuft über oder unter mehreren Fäden des anderen Systems. 100 % Abbindung ist Leinwandbindung.</translation>
    </message>
    <message>
        <source>Ends that never interlace: %1.</source>
        <translation>Kettfäden, die nie abbinden: %1.</translation>
    </message>
    <message>
        <source>Picks that never interlace: %1.</source>
        <translation>Schüsse, die nie abbinden: %1.</translation>
    </message>
    <message>
        <source>endless</source>
        <translation>endlos</translation>
    </message>
    <message>
        <source>Setts against their limit</source>
        <translation>Dichten gegen ihre Grenze</translation>
    </message>
    <message>
        <source>Setts: %1 % of their limit</source>
        <translation>Dichten: %1 % ihrer Grenze</translation>
    </message>
    <message>
        <source>Both setts together, for these yarns and this weave: at 100 % solid round yarns would jam. Looms stop at about %1 %.</source>
        <translation>Beide Dichten zusammen, für diese Garne und diese Bindung: Bei 100 % würden dichte, runde Garne klemmen. Webmaschinen enden bei etwa %1 %.</translation>
    </message>
    <message>
        <source>Ashenhurst&apos;s limit for square cloth, of which a firm one has about 75 %, is %1 ends and %2 picks.</source>
        <translation>Ashenhursts Grenze für quadratische Gewebe, von der ein festes etwa 75 % hat, ist %1 Kettfäden und %2 Schüsse.</translation>
    </message>
</context>
<context>
    <name>hygroloom::WhyView</name>
    <message>
        <source>Find &amp;Out</source>
        <translation>Hera&amp;usfinden</translation>
    </message>
    <message>
        <source>State of the question</source>
        <translation>Zustand der Frage</translation>
    </message>
    <message>
        <source>What the contributions rest on</source>
        <translation>Worauf die Beiträge beruhen</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Parts that differ and what they make</source>
        <translation>Teile, die sich unterscheiden, und was sie bewirken</translation>
    </message>
    <message>
        <source>&amp;Why is:</source>
        <translation>Warum i&amp;st:</translation>
    </message>
    <message>
        <source>a&amp;gainst:</source>
        <translation>geg&amp;en:</translation>
    </message>
    <message>
        <source>&amp;by:</source>
        <translation>&amp;nach:</translation>
    </message>
    <message>
        <source>Run fabrics that have some parts of the one and some of the other, and see what each part makes of the difference. The runs go on in the background.</source>
        <translation>Rechnet Gewebe, die manche Teile des einen und manche des anderen haben, und zeigt, was jeder Teil zum Unterschied beiträgt. Die Läufe gehen im Hintergrund weiter.</translation>
    </message>
    <message>
        <source>Choose an experiment of the project above.</source>
        <translation>Wählen Sie oben einen Versuch des Projekts.</translation>
    </message>
    <message>
        <source>Run the experiment on two fabrics of the project first (Run All Missing).</source>
        <translation>Rechnen Sie den Versuch zuerst mit zwei Geweben des Projekts (Alle fehlenden rechnen).</translation>
    </message>
    <message>
        <source>Choose two different fabrics.</source>
        <translation>Wählen Sie zwei verschiedene Gewebe.</translation>
    </message>
    <message>
        <source>Replicates of these fabrics are missing: Run All Missing runs them.</source>
        <translation>Wiederholungen dieser Gewebe fehlen: Alle fehlenden rechnen holt sie nach.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Contribution to the difference</source>
        <translation>Beitrag zum Unterschied</translation>
    </message>
    <message>
        <source>In words</source>
        <translation>In Worten</translation>
    </message>
    <message>
        <source>Looking for what differs…</source>
        <translation>Unterschiede werden gesucht …</translation>
    </message>
    <message>
        <source>1 run</source>
        <translation>1 Lauf</translation>
    </message>
    <message>
        <source>%1 runs</source>
        <translation>%1 Läufe</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>. Failed: %1</source>
        <translation>. Misslungen: %1</translation>
    </message>
    <message>
        <source>Ca&amp;ncel Runs</source>
        <translation>&amp;Läufe abbrechen</translation>
    </message>
    <message>
        <source>Mixtures of fabrics are run on samples alone. Choose an experiment on a sample above.</source>
        <translation>Mischungen von Geweben werden nur als Proben simuliert. Wählen Sie oben einen Versuch an einer Probe.</translation>
    </message>
</context>
<context>
    <name>hygroloom::YarnPanel</name>
    <message>
        <source>warp</source>
        <translation>Kette</translation>
    </message>
    <message>
        <source>weft</source>
        <translation>Schuss</translation>
    </message>
    <message>
        <source>stripe yarn</source>
        <translation>Streifengarn</translation>
    </message>
    <message>
        <source>Warp yarn</source>
        <translation>Kettgarn</translation>
    </message>
    <message>
        <source>Weft yarn</source>
        <translation>Schussgarn</translation>
    </message>
    <message>
        <source>Yarns of the stripes</source>
        <translation>Garne der Streifen</translation>
    </message>
    <message>
        <source>Crimp</source>
        <translation>Einwebung</translation>
    </message>
    <message>
        <source>How much longer the yarn is than the fabric.</source>
        <translation>Um wie viel länger das Garn ist als das Gewebe.</translation>
    </message>
    <message>
        <source>Fibre pores</source>
        <translation>Faserporen</translation>
    </message>
    <message>
        <source>Radius of the pores between the fibres; they draw water in by capillarity.</source>
        <translation>Radius der Poren zwischen den Fasern; sie saugen Wasser durch Kapillarität ein.</translation>
    </message>
    <message>
        <source>S twist</source>
        <translation>S-Drehung</translation>
    </message>
    <message>
        <source>Z twist</source>
        <translation>Z-Drehung</translation>
    </message>
    <message>
        <source>Same as warp</source>
        <translation>Wie die Kette</translation>
    </message>
    <message>
        <source>Weft yarn is the same as the warp yarn</source>
        <translation>Das Schussgarn ist gleich dem Kettgarn</translation>
    </message>
    <message>
        <source>weft same as warp</source>
        <translation>Schuss wie Kette</translation>
    </message>
    <message>
        <source>Yarns beside the fabric&apos;s own, which is A. Letters are those of the stripes, such as 12A 4B.</source>
        <translation>Garne neben dem eigenen des Gewebes, A. Die Buchstaben sind die der Streifen, etwa 12A 4B.</translation>
    </message>
    <message>
        <source>Yarn</source>
        <translation>Garn</translation>
    </message>
    <message>
        <source>Yarn of the stripes</source>
        <translation>Garn der Streifen</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Yarn Colour</source>
        <translation>Garnfarbe</translation>
    </message>
    <message>
        <source>%1 colour</source>
        <translation>%1: Farbe</translation>
    </message>
    <message>
        <source>Undyed</source>
        <translation>Ungefärbt</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Fibre</source>
        <translation>Faser</translation>
    </message>
    <message>
        <source>Blended with</source>
        <translation>Gemischt mit</translation>
    </message>
    <message>
        <source>%1 fibre</source>
        <translation>%1: Faser</translation>
    </message>
    <message>
        <source>%1 blend</source>
        <translation>%1: Mischung</translation>
    </message>
    <message>
        <source>%1 blend share</source>
        <translation>%1: Anteil der Mischung</translation>
    </message>
    <message>
        <source>Fraction of the first fibre, by dry mass.</source>
        <translation>Anteil der ersten Faser an der Trockenmasse.</translation>
    </message>
    <message>
        <source>undyed</source>
        <translation>ungefärbt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Of a core-spun yarn: the bare filament in its middle, which the fibres are spun round. It takes room from the pores and no liquid water.</source>
        <translation>Eines Kerngarns: das blanke Filament in seiner Mitte, um das die Fasern gesponnen sind. Es nimmt den Poren Raum und kein flüssiges Wasser auf.</translation>
    </message>
    <message>
        <source>Core</source>
        <translation>Kern</translation>
    </message>
    <message>
        <source>%1 core</source>
        <translation>Kern aus %1</translation>
    </message>
    <message>
        <source>Own fibre from the yarn&apos;s</source>
        <translation>Eigene Faser aus der des Garns</translation>
    </message>
    <message>
        <source>Own fibre from the blended one</source>
        <translation>Eigene Faser aus der beigemischten</translation>
    </message>
    <message>
        <source>Share of first fibre</source>
        <translation>Anteil der ersten Faser</translation>
    </message>
    <message>
        <source>own fibre</source>
        <translation>eigene Faser</translation>
    </message>
    <message>
        <source>Own fibre from the core&apos;s</source>
        <translation>Eigene Faser aus der des Kerns</translation>
    </message>
    <message>
        <source>Shows the values of this fibre of the project: cross-section, size, wetting, regain.</source>
        <translation>Zeigt die Werte dieser Faser des Projekts: Querschnitt, Größe, Benetzung, Feuchteaufnahme.</translation>
    </message>
    <message>
        <source>Copies this fibre into the project, where its cross-section, size, wetting and regain can be set.</source>
        <translation>Kopiert diese Faser in das Projekt, wo Querschnitt, Größe, Benetzung und Feuchteaufnahme eingestellt werden können.</translation>
    </message>
    <message>
        <source>Own…</source>
        <translation>Eigene…</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Ändern…</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Feinheit</translation>
    </message>
    <message>
        <source>count</source>
        <translation>Feinheit</translation>
    </message>
    <message>
        <source>As the trade writes it, with plies and filaments: %1. The diameter follows from it.</source>
        <translation>Wie im Handel üblich, mit Fachung und Filamenten: %1. Der Durchmesser folgt daraus.</translation>
    </message>
    <message>
        <source>from the count</source>
        <translation>aus der Feinheit</translation>
    </message>
    <message>
        <source>Yarns…</source>
        <translation>Garne…</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>&amp;Take from Library</source>
        <translation>Aus der Bibliothek &amp;nehmen</translation>
    </message>
    <message>
        <source>&amp;Keep in Library…</source>
        <translation>In der Bibliothek &amp;ablegen…</translation>
    </message>
    <message>
        <source>&amp;Replace in All Fabrics</source>
        <translation>In allen Geweben &amp;ersetzen</translation>
    </message>
    <message>
        <source>%1 from the library</source>
        <translation>%1 aus der Bibliothek</translation>
    </message>
    <message>
        <source>Keep in Library</source>
        <translation>In der Bibliothek ablegen</translation>
    </message>
    <message>
        <source>Name of the yarn; one of the same name is replaced:</source>
        <translation>Name des Garns; eines mit demselben Namen wird ersetzt:</translation>
    </message>
    <message>
        <source>yarn in all fabrics</source>
        <translation>Garn in allen Geweben</translation>
    </message>
    <message>
        <source>Takes the yarn from your library, keeps it there, or replaces it in all fabrics of the project. A yarn that was taken from it or kept in it bears its name here, and can be brought up to date with it.</source>
        <translation>Nimmt das Garn aus Ihrer Bibliothek, legt es dort ab oder ersetzt es in allen Geweben des Projekts. Ein Garn, das aus ihr genommen oder in ihr abgelegt wurde, trägt hier seinen Namen und kann nach ihr aktualisiert werden.</translation>
    </message>
    <message>
        <source>&amp;Update All from Library</source>
        <translation>Alle aus der Bibliothek &amp;aktualisieren</translation>
    </message>
    <message>
        <source>Brings all yarns of the project that were taken from the library up to date with it.</source>
        <translation>Aktualisiert alle Garne des Projekts, die aus der Bibliothek genommen wurden.</translation>
    </message>
    <message>
        <source>&amp;Separate from Library</source>
        <translation>Von der Bibliothek &amp;lösen</translation>
    </message>
    <message>
        <source>separated from the library</source>
        <translation>von der Bibliothek gelöst</translation>
    </message>
    <message>
        <source>%1 kept in the library</source>
        <translation>%1 in der Bibliothek abgelegt</translation>
    </message>
    <message>
        <source>yarns from the library</source>
        <translation>Garne aus der Bibliothek</translation>
    </message>
    <message>
        <source>All yarns that were taken from the library are as they are there.</source>
        <translation>Alle Garne, die aus der Bibliothek genommen wurden, sind so wie dort.</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>The library has no such yarn. It stays as it is.</source>
        <translation>Die Bibliothek hat kein solches Garn. Es bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>Update All from Library</source>
        <translation>Alle aus der Bibliothek aktualisieren</translation>
    </message>
    <message>
        <source>no price</source>
        <translation>kein Preis</translation>
    </message>
</context>
<context>
    <name>hygroloom::ZonesForm</name>
    <message>
        <source>Draw a zone on a flat panel: click its corners, and the first one again</source>
        <translation>Eine Zone auf ein flaches Schnittteil zeichnen: Klicken Sie ihre Ecken und noch einmal die erste an</translation>
    </message>
    <message>
        <source>Rename the selected zone</source>
        <translation>Die gewählte Zone umbenennen</translation>
    </message>
    <message>
        <source>Delete the selected zone</source>
        <translation>Die gewählte Zone löschen</translation>
    </message>
    <message>
        <source>Own zones</source>
        <translation>Eigene Zonen</translation>
    </message>
    <message>
        <source>Zone</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Sweats</source>
        <translation>Schwitzt</translation>
    </message>
    <message>
        <source>In place of the body&apos;s zone; times the factor of the activity.</source>
        <translation>Anstelle der Zone des Körpers; mal dem Faktor der Aktivität.</translation>
    </message>
    <message>
        <source>Rename the Zone</source>
        <translation>Zone umbenennen</translation>
    </message>
    <message>
        <source>rename zone</source>
        <translation>Zone umbenennen</translation>
    </message>
    <message>
        <source>Sweat of own zone %1</source>
        <translation>Schweiß der eigenen Zone %1</translation>
    </message>
    <message>
        <source>change sweat of a zone</source>
        <translation>Schweiß einer Zone ändern</translation>
    </message>
    <message>
        <source>%1, on %2</source>
        <translation>%1, auf %2</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Design woven fabrics and simulate how they take up water.</source>
        <translation>Gewebe entwerfen und simulieren, wie sie Wasser aufnehmen.</translation>
    </message>
    <message>
        <source>Write a report (.json) as PDF, without a window: --pdf page.json page.pdf.</source>
        <translation>Einen Bericht (.json) ohne Fenster als PDF schreiben: --pdf seite.json seite.pdf.</translation>
    </message>
    <message>
        <source>A project (.hygro) or a recording (.hygrorec).</source>
        <translation>Ein Projekt (.hygro) oder eine Aufzeichnung (.hygrorec).</translation>
    </message>
</context>
</TS>
